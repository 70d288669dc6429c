// A headless Chromium on a pipe (DevTools protocol, JSON messages ended by a zero byte): no port, no packages.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const flags = [
  "--headless",
  "--no-sandbox",
  "--disable-dev-shm-usage",
  "--use-angle=swiftshader", // WebGL without a graphics card
  "--enable-unsafe-swiftshader",
  "--hide-scrollbars",
  "--remote-debugging-pipe",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--force-color-profile=srgb",
];

export class Chromium {
  #child;
  #profile;
  #waiting = new Map();
  #listeners = [];
  #rest = "";
  #next = 1;

  constructor() {
    this.#profile = mkdtempSync(join(tmpdir(), "cleave-chromium-"));
    this.#child = spawn(process.env.CHROMIUM ?? "chromium", [...flags, `--user-data-dir=${this.#profile}`, "about:blank"], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
    });
    this.#child.stdio[4].setEncoding("utf8").on("data", (text) => this.#receive(text));
    this.#child.stdio[3].on("error", () => {});
    this.#child.on("exit", () => this.#fail_all("Chromium ended"));
    this.#child.on("error", (error) => this.#fail_all(`Chromium did not start: ${error.message}`));
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.#next++;
    this.#child.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject, method }));
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  async close() {
    const ended = new Promise((resolve) => this.#child.once("exit", resolve));
    this.send("Browser.close").catch(() => {});
    const late = setTimeout(() => this.#child.kill("SIGKILL"), 5000);
    await ended;
    clearTimeout(late);
    rmSync(this.#profile, { recursive: true, force: true, maxRetries: 5 });
  }

  #fail_all(why) {
    for (const { reject, method } of this.#waiting.values()) reject(new Error(`${method}: ${why}`));
    this.#waiting.clear();
  }

  #receive(text) {
    const messages = (this.#rest + text).split("\0");
    this.#rest = messages.pop();
    for (const message of messages.map((part) => JSON.parse(part))) {
      const waiting = this.#waiting.get(message.id);
      if (!waiting) {
        for (const listener of this.#listeners) listener(message);
        continue;
      }
      this.#waiting.delete(message.id);
      if (message.error) waiting.reject(new Error(`${waiting.method}: ${message.error.message}`));
      else waiting.resolve(message.result);
    }
  }
}

/// One tab. `requests` and `log` collect what the page asked for and complained about.
export class Tab {
  requests = [];
  log = [];
  #browser;
  #target;
  #session;

  static async open(browser, width) {
    const tab = new Tab();
    tab.#browser = browser;
    ({ targetId: tab.#target } = await browser.send("Target.createTarget", { url: "about:blank" }));
    ({ sessionId: tab.#session } = await browser.send("Target.attachToTarget", { targetId: tab.#target, flatten: true }));
    browser.listen((message) => message.sessionId === tab.#session && tab.#note(message));
    for (const domain of ["Page", "Runtime", "Network", "Log"]) await tab.send(`${domain}.enable`);
    await tab.resize(width);
    return tab;
  }

  send(method, params) {
    return this.#browser.send(method, params, this.#session);
  }

  resize(width) {
    return this.send("Emulation.setDeviceMetricsOverride", { width, height: 900, deviceScaleFactor: 1, mobile: width < 600 });
  }

  emulate(media, scheme) {
    return this.send("Emulation.setEmulatedMedia", { media, features: [{ name: "prefers-color-scheme", value: scheme }] });
  }

  /// Opens a file and waits until `ready` (an expression) holds. Returns whether it did within `seconds`.
  async go(url, ready, seconds) {
    await this.send("Page.navigate", { url });
    for (let waited = 0; waited < seconds * 20; ++waited) {
      if (await this.evaluate(`document.readyState === "complete" && Boolean(${ready})`)) return true;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return false;
  }

  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async press(key) {
    const code = { Enter: 13, Tab: 9 }[key];
    const event = { key, code: key, windowsVirtualKeyCode: code, ...(key === "Enter" ? { text: "\r" } : {}) };
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", ...event });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", ...event });
  }

  /// The whole page as a PNG.
  async picture() {
    const { cssContentSize } = await this.send("Page.getLayoutMetrics");
    const clip = { x: 0, y: 0, width: cssContentSize.width, height: Math.min(cssContentSize.height, 12000), scale: 1 };
    const { data } = await this.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: true, clip });
    return Buffer.from(data, "base64");
  }

  close() {
    return this.#browser.send("Target.closeTarget", { targetId: this.#target });
  }

  #note({ method, params }) {
    if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    if (method === "Runtime.exceptionThrown") this.log.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
    if (method === "Log.entryAdded" && params.entry.level === "error") this.log.push(params.entry.text);
    if (method === "Runtime.consoleAPICalled" && params.type === "error")
      this.log.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
  }
}
