// Plays the animated surface of one scene at a time (three.js). Where there is no WebGL, it says so.

import {
  ACESFilmicToneMapping,
  AnimationMixer,
  Box3,
  Color,
  DirectionalLight,
  GridHelper,
  HemisphereLight,
  type Object3D,
  PerspectiveCamera,
  Scene as World,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { el } from "./dom";

export interface Play {
  title: string;
  surface: string; // glTF binary, base64
}

interface Loaded {
  root: Object3D;
  mixer: AnimationMixer;
  duration: number;
}

function bytes_of(base64: string): ArrayBuffer {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

async function load(play: Play): Promise<Loaded> {
  const { scene: root, animations } = await new GLTFLoader().parseAsync(bytes_of(play.surface), "");
  const mixer = new AnimationMixer(root);
  for (const clip of animations) mixer.clipAction(clip).play();
  const duration = Math.max(0, ...animations.map((clip) => clip.duration));
  return { root, mixer, duration };
}

/// At its very end an action begins anew: stay just before.
function set_time({ mixer, duration }: Loaded, time: number): void {
  mixer.setTime(Math.min(time, duration * (1 - 1e-6)));
}

/// The box of all that is seen at the start, in the middle and at the end.
function reach(loaded: Loaded): Box3 {
  const { root, duration } = loaded;
  const box = new Box3();
  for (const share of [0, 0.5, 1]) {
    set_time(loaded, share * duration);
    root.updateMatrixWorld(true);
    root.traverseVisible((part) => {
      const scale = part.getWorldScale(new Vector3());
      if (scale.x > 0.5 && "isMesh" in part) box.expandByObject(part);
    });
  }
  return box;
}

class Stage {
  readonly #renderer: WebGLRenderer;
  readonly #world = new World();
  readonly #camera = new PerspectiveCamera(35, 16 / 9, 0.001, 1000);
  readonly #controls: OrbitControls;
  readonly #frame: HTMLElement;
  readonly #time: HTMLInputElement;
  readonly #button: HTMLButtonElement;
  #loaded: Loaded | null = null;
  #grid: GridHelper | null = null;
  #last: number | null = null;
  #width = 0;

  constructor(frame: HTMLElement, time: HTMLInputElement, button: HTMLButtonElement) {
    this.#frame = frame;
    this.#time = time;
    this.#button = button;
    this.#renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.#renderer.toneMapping = ACESFilmicToneMapping;
    this.#world.background = new Color(0xdfe4e8);
    this.#world.add(new HemisphereLight(0xffffff, 0x8a8f94, 2.2));
    const sun = new DirectionalLight(0xffffff, 2.5);
    sun.position.set(2, 4, 3);
    this.#world.add(sun);
    frame.append(this.#renderer.domElement);
    this.#controls = new OrbitControls(this.#camera, this.#renderer.domElement);
    this.#controls.addEventListener("change", () => this.draw());
    new ResizeObserver(() => requestAnimationFrame(() => this.#resize())).observe(frame);
    time.addEventListener("input", () => this.#show(Number(time.value)));
    button.addEventListener("click", () => (this.#last === null ? this.#start() : this.#stop()));
  }

  async open(play: Play): Promise<void> {
    this.#stop();
    if (this.#loaded) this.#world.remove(this.#loaded.root);
    this.#loaded = await load(play);
    this.#world.add(this.#loaded.root);
    this.#look_at(reach(this.#loaded));
    this.#time.max = String(this.#loaded.duration);
    this.#resize();
    this.#show(0.6 * this.#loaded.duration);
  }

  draw(): void {
    this.#renderer.render(this.#world, this.#camera);
  }

  #look_at(box: Box3): void {
    const centre = box.getCenter(new Vector3());
    const radius = box.getSize(new Vector3()).length() / 2;
    this.#camera.near = radius / 100;
    this.#camera.far = radius * 100;
    this.#camera.position.copy(centre).add(new Vector3(0.9, 0.55, 1.4).normalize().multiplyScalar(radius / Math.sin((17 * Math.PI) / 180)));
    this.#controls.target.copy(centre);
    this.#controls.update();
    if (this.#grid) this.#world.remove(this.#grid);
    this.#grid = new GridHelper(8 * radius, 32, 0x9aa4ad, 0xc3cad0);
    this.#grid.position.y = Math.min(0, box.min.y) - 1e-3 * radius;
    this.#world.add(this.#grid);
  }

  #resize(): void {
    const width = this.#frame.clientWidth;
    if (width === 0 || width === this.#width) return;
    this.#width = width;
    const height = Math.round(Math.min((width * 9) / 16, 560));
    this.#renderer.setPixelRatio(window.devicePixelRatio);
    this.#renderer.setSize(width, height);
    this.#camera.aspect = width / height;
    this.#camera.updateProjectionMatrix();
    this.draw();
  }

  #show(time: number): void {
    this.#time.value = String(time);
    this.#time.setAttribute("aria-valuetext", `${time.toFixed(2)} s`);
    if (this.#loaded) set_time(this.#loaded, time);
    this.draw();
  }

  #start(): void {
    this.#button.textContent = "Pause";
    this.#last = performance.now();
    if (this.#loaded && Number(this.#time.value) >= this.#loaded.duration - 1e-3) this.#show(0);
    const step = (now: number): void => {
      if (this.#last === null || !this.#loaded) return;
      const time = Number(this.#time.value) + (now - this.#last) / 1000;
      this.#last = now;
      if (time >= this.#loaded.duration) {
        this.#show(this.#loaded.duration);
        this.#stop();
        return;
      }
      this.#show(time);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  #stop(): void {
    this.#button.textContent = "Play";
    this.#last = null;
  }
}

export function has_webgl(): boolean {
  return document.createElement("canvas").getContext("webgl2") !== null;
}

export function stage(plays: Play[]): HTMLElement {
  if (!has_webgl()) return el("p", { class: "missing" }, "This browser has no WebGL: the scenes cannot play here. Their surface.glb files open in Blender.");
  const frame = el("div", { class: "stage-view", role: "img", "aria-label": "Animated surfaces of the chosen scene" });
  const choice = el("select", {}, ...plays.map((play, i) => el("option", { value: String(i) }, play.title)));
  const time = el("input", { type: "range", min: "0", max: "1", step: "0.01", value: "0", "aria-label": "Time of the scene" });
  const button = el("button", { type: "button", class: "play" }, "Play");
  const status = el("p", { class: "status", role: "status" });
  const shown = new Stage(frame, time, button);
  const open = async (): Promise<void> => {
    const play = plays[Number(choice.value)];
    try {
      await shown.open(play);
      status.textContent = "Drag to turn, wheel to approach; the pale, rough faces are cracks.";
      frame.dataset.shown = play.title;
    } catch (error) {
      status.textContent = `${play.title}: its surface cannot be read (${String(error)}).`;
    }
  };
  choice.addEventListener("change", () => void open());
  void open();
  return el("div", { class: "stage" }, el("div", { class: "filters" }, el("label", {}, "Scene", choice), button, time), frame, status);
}
