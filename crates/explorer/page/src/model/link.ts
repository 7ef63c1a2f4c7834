// State in the address: "#1:" and the study as deflated JSON in base64url, with the text of the model.

import type { Study } from '../engine/protocol';
import type { PanelTables } from './answers';
import type { ModelFiles } from './files';

/** `text`, `files`: the model, and its further files in base64. Both are omitted if they are long; the link then requires a page with this
 * model. */
export interface LinkedState { study: Study; text?: string; files?: Record<string, string>; driver?: string; view?: string; tab?: string; hidesHints?: boolean }

export type ViewName = '3d' | 'front' | 'side' | 'top';

/** Content of a page at its start. */
export interface Start {
  model?: ModelFiles;
  study?: Partial<Study> & { panels?: PanelTables };
  driver?: string;
  view?: ViewName;
  /** Variants of a study; the page shows them as frozen variants. */
  variants?: (Partial<Study> & { name: string })[];
}

const VERSION = '1';
/** Largest length of a model with its files in a link, characters: browsers and mail programs cut longer addresses. */
const LONGEST_TEXT = 60_000;

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const piped = new Blob([bytes as BlobPart]).stream().pipeThrough(stream as unknown as TransformStream<Uint8Array, Uint8Array>);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

export async function toHash(state: LinkedState): Promise<string> {
  const length = Object.values(state.files ?? {}).reduce((sum, text) => sum + text.length, state.text!.length);
  const short = length > LONGEST_TEXT ? { ...state, text: undefined, files: undefined } : state;
  const packed = await through(new TextEncoder().encode(JSON.stringify(short)), new CompressionStream('deflate-raw'));
  const text = btoa(Array.from(packed, (byte) => String.fromCharCode(byte)).join(''));
  return `#${VERSION}:${text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')}`;
}

/** State in the fragment of an address; null without a fragment. Throws an error if the fragment has another version or is damaged. */
export async function fromHash(hash: string): Promise<LinkedState | null> {
  if (hash.length < 2) return null;
  const [version, text] = [hash.slice(1, hash.indexOf(':')), hash.slice(hash.indexOf(':') + 1)];
  if (!hash.includes(':') || version !== VERSION) throw new Error(`the link is of another version of this page (${version.slice(0, 8)})`);
  try {
    const packed = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
    const state = JSON.parse(new TextDecoder().decode(await through(packed, new DecompressionStream('deflate-raw'))));
    if (typeof state?.study?.model?.path !== 'string') throw new Error();
    return state as LinkedState;
  } catch {
    throw new Error('the link is damaged: a part of it is missing');
  }
}
