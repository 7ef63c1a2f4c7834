// Engine in a worker: the first message has the bytes of the module, the others have requests.

import { Module } from './module';

let starting: Promise<Module> | undefined;

self.onmessage = async (event: MessageEvent<{ bytes?: Uint8Array<ArrayBuffer>; request?: string }>) => {
  const { bytes, request } = event.data;
  try {
    if (bytes) starting = Module.start(bytes);
    const module = await starting;
    self.postMessage(bytes ? { ready: true } : { reply: module!.ask(request!), memory: module!.memory });
  } catch (error) {
    starting = undefined;
    self.postMessage({ failed: String(error) });
  }
};
