// Three views of the same points, with one camera and one renderer: the views share its canvas, each in a rectangle of its own.

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  type Material,
  PerspectiveCamera,
  Points as Cloud,
  Scene as World,
  ShaderMaterial,
  Spherical,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Points } from "./stress_field";

/// What is left of the body: the points whose coordinate is at most `at`, m.
export interface Cut {
  axis: number; ///< 0, 1, 2
  at: number;
}

/// Balls as discs that face the reader, shaded a little so that the shape can be seen without falsifying the colour.
const vertex_shader = `
  attribute float radius;
  attribute vec3 tint;
  uniform float height;
  uniform vec4 cut;
  varying vec3 shown;
  void main() {
    shown = tint;
    vec4 at = modelViewMatrix * vec4(position, 1.0);
    gl_Position = projectionMatrix * at;
    gl_PointSize = max(2.0, radius * projectionMatrix[1][1] * height / -at.z);
    if (dot(cut.xyz, position) > cut.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  }`;
const fragment_shader = `
  varying vec3 shown;
  void main() {
    vec2 off = 2.0 * gl_PointCoord - 1.0;
    float square = dot(off, off);
    if (square > 1.0) discard;
    gl_FragColor = vec4(shown * (0.78 + 0.22 * sqrt(1.0 - square)), 1.0);
  }`;

function cloud_material(): ShaderMaterial {
  const uniforms = { height: { value: 1 }, cut: { value: [0, 0, 0, 1] } };
  return new ShaderMaterial({ vertexShader: vertex_shader, fragmentShader: fragment_shader, uniforms });
}

const turn = Math.PI / 18;

export class FieldViews {
  readonly #renderer: WebGLRenderer;
  readonly #camera = new PerspectiveCamera(30, 1, 0.001, 1000);
  readonly #controls: OrbitControls;
  readonly #material = cloud_material();
  readonly #worlds: World[] = [];
  #box = new Box3();

  /// `cells`: elements inside `frame` whose places the views take.
  constructor(
    private readonly frame: HTMLElement,
    private readonly cells: HTMLElement[],
  ) {
    this.#renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.#renderer.setScissorTest(true);
    frame.append(this.#renderer.domElement);
    this.#camera.up.set(0, 0, 1); // before the controls, which turn about it
    this.#controls = new OrbitControls(this.#camera, this.#renderer.domElement);
    this.#controls.enablePan = false;
    this.#controls.enableZoom = false; // a wheel that passes by scrolls the page
    frame.addEventListener("focusin", () => (this.#controls.enableZoom = true));
    frame.addEventListener("focusout", () => (this.#controls.enableZoom = false));
    this.#renderer.domElement.addEventListener("pointerdown", () => frame.focus({ preventScroll: true }));
    this.#renderer.domElement.style.touchAction = "pan-y"; // a finger that goes up or down scrolls the page
    this.#controls.addEventListener("change", () => this.draw());
    frame.addEventListener("keydown", (event) => this.#press(event));
    new ResizeObserver(() => requestAnimationFrame(() => this.draw())).observe(frame);
  }

  /// `tints`: three bytes per point, for each view.
  show(points: Points, tints: Uint8Array[]): void {
    const position = new BufferAttribute(points.position, 3);
    const radius = new BufferAttribute(points.radius, 1);
    for (const world of this.#worlds) world.traverse((part) => (part as Cloud<BufferGeometry, Material>).geometry?.dispose());
    this.#worlds.length = 0;
    for (const tint of tints) {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", position).setAttribute("radius", radius).setAttribute("tint", new BufferAttribute(tint, 3, true));
      const cloud = new Cloud(geometry, this.#material);
      cloud.frustumCulled = false;
      this.#worlds.push(new World().add(cloud));
    }
    const box = new Box3().setFromBufferAttribute(position);
    const same = box.equals(this.#box);
    this.#box = box;
    if (!same) this.look();
    this.draw();
  }

  cut(cut: Cut | null): void {
    const normal = [0, 1, 2].map((axis) => (cut?.axis === axis ? 1 : 0));
    this.#material.uniforms.cut.value = [...normal, cut ? cut.at : 1];
    this.draw();
  }

  /// Back to the first view.
  look(): void {
    const centre = this.#box.getCenter(new Vector3());
    const radius = this.#box.getSize(new Vector3()).length() / 2 || 1;
    const away = (0.93 * radius) / Math.sin((this.#camera.fov * Math.PI) / 360);
    this.#camera.near = radius / 100;
    this.#camera.far = radius * 100;
    this.#controls.target.copy(centre);
    this.#camera.position.copy(centre).add(this.#first_direction().multiplyScalar(away));
    this.#controls.update();
    this.draw();
  }

  /// From a corner; onto the face of a thin body.
  #first_direction(): Vector3 {
    const extents = this.#box.getSize(new Vector3()).toArray();
    const thin = extents.indexOf(Math.min(...extents));
    const [, middle] = [...extents].sort((a, b) => a - b);
    if (extents[thin] > 0.4 * middle) return new Vector3(0.55, -0.75, 0.45).normalize();
    return new Vector3(0.35, -0.4, 0.3).setComponent(thin, thin === 1 ? -1 : 1).normalize();
  }

  draw(): void {
    const outer = this.frame.getBoundingClientRect();
    if (outer.width === 0) return;
    const size = this.#renderer.getSize(new Vector2());
    const ratio = window.devicePixelRatio;
    if (size.x !== Math.round(outer.width) || size.y !== Math.round(outer.height) || this.#renderer.getPixelRatio() !== ratio) {
      this.#renderer.setPixelRatio(ratio);
      this.#renderer.setSize(Math.round(outer.width), Math.round(outer.height), false);
    }
    this.#worlds.forEach((world, i) => {
      const cell = this.cells[i].getBoundingClientRect();
      const place = [cell.left - outer.left, outer.bottom - cell.bottom, cell.width, cell.height] as const;
      this.#renderer.setViewport(...place);
      this.#renderer.setScissor(...place);
      this.#camera.aspect = cell.width / cell.height;
      this.#camera.updateProjectionMatrix();
      this.#material.uniforms.height.value = cell.height * ratio;
      this.#renderer.render(world, this.#camera);
    });
  }

  #press(event: KeyboardEvent): void {
    const steps: Record<string, () => void> = {
      ArrowLeft: () => this.#turn(-turn, 0),
      ArrowRight: () => this.#turn(turn, 0),
      ArrowUp: () => this.#turn(0, -turn),
      ArrowDown: () => this.#turn(0, turn),
      "+": () => this.#approach(1 / 1.15),
      "-": () => this.#approach(1.15),
      Home: () => this.look(),
    };
    const step = event.ctrlKey || event.metaKey || event.altKey ? undefined : steps[event.key];
    if (!step) return;
    event.preventDefault();
    step();
  }

  /// By angles about the vertical axis and towards it. The spherical coordinates have y as their pole, the views z.
  #turn(around: number, down: number): void {
    const off = this.#camera.position.clone().sub(this.#controls.target);
    const place = new Spherical().setFromVector3(new Vector3(off.x, off.z, -off.y));
    place.theta += around;
    place.phi += down;
    place.makeSafe();
    const moved = new Vector3().setFromSpherical(place);
    this.#camera.position.copy(this.#controls.target).add(new Vector3(moved.x, -moved.z, moved.y));
    this.#controls.update();
    this.draw();
  }

  #approach(factor: number): void {
    this.#camera.position.sub(this.#controls.target).multiplyScalar(factor).add(this.#controls.target);
    this.#controls.update();
    this.draw();
  }
}
