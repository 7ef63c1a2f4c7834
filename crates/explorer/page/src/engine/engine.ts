// Engine of the page. Requests are processed in order; a long computation can be cancelled.

import { decodeLzma } from './lzma';
import { Module } from './module';
import type { Outcome, Request } from './protocol';

declare const WORKER_SOURCE: string;

export class Ended extends Error {}

/** Bytes of the module in the page: base64 of the format .lzma, which is a fifth smaller than gzip. */
function moduleBytes(): Uint8Array<ArrayBuffer> {
  const text = document.getElementById('engine')!.textContent!;
  return decodeLzma(Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0)));
}

interface Pending { resolve(reply: string): void; reject(error: Error): void }

/** Engine in a worker, or in the page where workers are not permitted. */
export class Engine {
  private worker: Worker | undefined;
  private module: Module | undefined;
  private pending: Pending | undefined;
  /** Memory of the module, bytes. */
  memory = 0;
  private queue: Promise<unknown> = Promise.resolve();

  private constructor(private readonly bytes: Uint8Array<ArrayBuffer>) {}

  static async start(): Promise<Engine> {
    const engine = new Engine(moduleBytes());
    await engine.restart();
    return engine;
  }

  private async restart() {
    try {
      const url = URL.createObjectURL(new Blob([WORKER_SOURCE], { type: 'text/javascript' }));
      this.worker = new Worker(url);
      URL.revokeObjectURL(url);
      await this.post({ bytes: this.bytes });
    } catch {
      this.worker = undefined;
      this.module = await Module.start(this.bytes);
    }
  }

  private post(message: object): Promise<string> {
    return new Promise((resolve, reject) => {
      const worker = this.worker!;
      this.pending = { resolve, reject };
      worker.onmessage = ({ data }) => {
        this.pending = undefined;
        this.memory = data.memory ?? this.memory;
        if (data.failed) reject(new Error(data.failed));
        else resolve(data.reply);
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(event.message || 'the worker did not start'));
      };
      worker.postMessage(message);
    });
  }

  ask<T>(request: Request): Promise<Outcome<T>> {
    const run = async () => {
      const text = JSON.stringify(request);
      const reply = this.worker ? await this.post({ request: text }) : this.module!.ask(text);
      return JSON.parse(reply) as Outcome<T>;
    };
    const asked = this.queue.then(run);
    this.queue = asked.catch(() => undefined);
    return asked;
  }

  /** Cancels the current request; afterwards no model is open. */
  async end() {
    if (!this.worker) return;
    this.worker.terminate();
    const pending = this.pending;
    this.pending = undefined;
    await this.restart();
    pending?.reject(new Ended('ended'));
  }
}
