// WebAssembly module of the engine: JSON in, JSON out.

interface Exports {
  memory: WebAssembly.Memory;
  percuss_request(length: number): number;
  percuss_answer(): number;
  percuss_reply(): number;
}

export class Module {
  private constructor(private readonly exports: Exports) {}

  static async start(bytes: Uint8Array<ArrayBuffer>): Promise<Module> {
    const { instance } = await WebAssembly.instantiate(bytes, {});
    return new Module(instance.exports as unknown as Exports);
  }

  /** Bytes of the memory of the module. */
  get memory(): number {
    return this.exports.memory.buffer.byteLength;
  }

  /** Reply to a request, both as JSON text. */
  ask(request: string): string {
    const bytes = new TextEncoder().encode(request);
    const at = this.exports.percuss_request(bytes.length);
    new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
    const length = this.exports.percuss_answer();
    return new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, this.exports.percuss_reply(), length));
  }
}
