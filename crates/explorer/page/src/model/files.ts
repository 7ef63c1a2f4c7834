// Files of a folder that is dropped on the page or chosen: the models in it, and the files that a model names.

/** File with its path from the folder on, with "/". */
export interface NamedFile { path: string; file: File }

/** Model of a folder; `within`: a file that includes it. */
export interface FoundModel { path: string; text: string; kind: string; within?: string }

/** Model with the further files that the engine gets, in base64 by path. */
export interface ModelFiles { name: string; text: string; files?: Record<string, string>; shapes?: (string | null)[] }

const MOST_FILES = 20_000;
/** Largest size of the files that the engine gets, bytes: several copies of them are in memory while a model is opened. */
const LARGEST_TOTAL = 64 * 2 ** 20;
/** Largest model file of the reader, bytes. */
const LARGEST_TEXT = 32 * 2 ** 20;
/** Folders without models. */
const SKIPPED = /^(\.|node_modules$|__MACOSX$)/;
const ROOTS: Record<string, string> = { robot: 'URDF', mujoco: 'MJCF', sdf: 'SDFormat' };
const MODEL = /\.(urdf|xml|mjcf|sdf|world|toml|json)$/i;
const TEXT = /\.(urdf|xml|mjcf|sdf|world|config|toml|csv|json|sub)$/i;

const base = (path: string) => path.replace(/.*\//, '');

/** Files of an input element for a folder. */
export function filesOfInput(list: FileList): NamedFile[] {
  const all = Array.from(list, (file) => ({ path: file.webkitRelativePath || file.name, file }));
  return all.filter(({ path }) => !path.split('/').some((part) => SKIPPED.test(part)));
}

/** File or folder that is dropped. */
interface Node { name: string; file?(): Promise<File>; children?(): Promise<Node[]> }

/** Interface of the File System API, which Chromium has. */
interface Handle { kind: 'file' | 'directory'; name: string; getFile(): Promise<File>; values(): AsyncIterable<Handle> }
type Item = DataTransferItem & { getAsFileSystemHandle?(): Promise<Handle | null> };

/** Dropped files, with those in dropped folders. The items expire with the event, so that they are read before the first wait. */
export async function filesOfDrop(data: DataTransfer): Promise<NamedFile[]> {
  const plain = [...data.files].map((file) => ({ path: file.name, file }));
  const items = [...data.items].filter((item) => item.kind === 'file') as Item[];
  const entries = items.map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) return plain;
  // Chromium reads no entries in a page from a file, only handles.
  const handles = items.map((item) => item.getAsFileSystemHandle?.());
  const found: NamedFile[] = [];
  for (const [i, entry] of entries.entries()) {
    const handle = await handles[i];
    const node = handle ? ofHandle(handle) : entry && ofEntry(entry);
    if (node) await walk(node, '', found);
  }
  return found;
}

function ofHandle(handle: Handle): Node {
  const { name } = handle;
  if (handle.kind === 'file') return { name, file: () => handle.getFile() };
  const children = async () => {
    const all: Node[] = [];
    for await (const child of handle.values()) all.push(ofHandle(child));
    return all;
  };
  return { name, children };
}

function ofEntry(entry: FileSystemEntry): Node {
  const { name } = entry;
  if (entry.isFile) return { name, file: () => new Promise((done, failed) => (entry as FileSystemFileEntry).file(done, failed)) };
  const children = async () => {
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    const all: Node[] = [];
    for (;;) {
      // A reader returns at most a hundred entries at once.
      const some = await new Promise<FileSystemEntry[]>((done, failed) => reader.readEntries(done, failed));
      if (!some.length) return all;
      all.push(...some.map(ofEntry));
    }
  };
  return { name, children };
}

/** Appends the file, or all files of the folder. */
async function walk(node: Node, folder: string, found: NamedFile[]): Promise<void> {
  if (SKIPPED.test(node.name)) return;
  if (found.length >= MOST_FILES) throw new Error(`it has more than ${MOST_FILES} files; choose a folder below it`);
  const path = folder ? `${folder}/${node.name}` : node.name;
  if (node.file) found.push({ path, file: await node.file() });
  for (const child of (await node.children?.()) ?? []) await walk(child, path, found);
}

/** Name of the format of a model; undefined for other files. */
function kindOf(path: string, text: string): string | undefined {
  if (/\.toml$/i.test(path)) return /^\s*template\s*=/m.test(text) ? 'suspension sheet' : undefined;
  if (/\.json$/i.test(path)) return /"Type"\s*:\s*"Suspension"/.test(text) ? 'Chrono::Vehicle' : undefined;
  const root = /^\uFEFF?\s*(?:<\?[^>]*\?>\s*|<!--[^]*?-->\s*|<![^>]*>\s*)*<([A-Za-z]+)[\s>/]/.exec(text)?.[1];
  return root && ROOTS[root];
}

/** Parts of the paths and names in a text. */
function namesIn(text: string): Set<string> {
  return new Set(text.split(/["'<>\n/\\]+/).map((part) => part.trim()));
}

/** Models of a folder, first those that no other model includes. */
export async function modelsOf(files: NamedFile[]): Promise<FoundModel[]> {
  const found: FoundModel[] = [];
  for (const { path, file } of files) {
    if (!MODEL.test(path) || file.size > LARGEST_TEXT) continue;
    const text = await file.text();
    const kind = kindOf(path, text);
    if (kind) found.push({ path, text, kind });
  }
  for (const model of found) {
    const includes = [...model.text.matchAll(/<include\b[^>]*\bfile\s*=\s*["']([^"']+)["']/g)].map((match) => base(match[1]));
    for (const other of found) if (other !== model && includes.includes(base(other.path))) other.within ??= model.path;
  }
  const rank = (model: FoundModel) => (model.within ? 1 : 0);
  return found.sort((a, b) => rank(a) - rank(b) || a.path.localeCompare(b.path));
}

/** The files of a folder that a model names, also through its included files; `left`: the files beyond the limit of size. */
export async function filesOfModel(model: FoundModel, files: NamedFile[]): Promise<{ model: ModelFiles; left: string[] }> {
  const wanted = new Map<string, File>();
  const texts = [model.text];
  for (let text = texts.pop(); text !== undefined; text = texts.pop()) {
    const names = namesIn(text);
    for (const { path, file } of files) {
      if (path === model.path || wanted.has(path)) continue;
      // An <include> of SDFormat names the folder of a model, not its file.
      const parts = path.split('/');
      const isOfFolder = /\.(sdf|config)$/i.test(path) && names.has(parts.at(-2) ?? '');
      if (!names.has(parts.at(-1)!) && !isOfFolder) continue;
      wanted.set(path, file);
      if (TEXT.test(path) && file.size <= LARGEST_TEXT) texts.push(await file.text());
    }
  }
  const taken: Record<string, string> = {};
  const left: string[] = [];
  let total = model.text.length;
  for (const [path, file] of [...wanted].sort(([a, x], [b, y]) => Number(TEXT.test(b)) - Number(TEXT.test(a)) || x.size - y.size)) {
    total += file.size;
    if (total > LARGEST_TOTAL) left.push(path);
    else taken[path] = await base64(file);
  }
  return { model: { name: model.path, text: model.text, ...(Object.keys(taken).length ? { files: taken } : {}) }, left };
}

function base64(file: File): Promise<string> {
  return new Promise((done, failed) => {
    const reader = new FileReader();
    reader.onload = () => done((reader.result as string).split(',')[1] ?? '');
    reader.onerror = () => failed(new Error(`${file.name}: ${reader.error?.message ?? 'cannot be read'}`));
    reader.readAsDataURL(file);
  });
}
