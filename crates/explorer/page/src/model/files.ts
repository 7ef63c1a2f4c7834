// Files of a dropped or chosen folder: its models, and the files to which a model refers.

/** File with its path, which starts with the name of the folder and has the separator "/". */
export interface NamedFile { path: string; file: File }

/** Model in a folder; `within`: path of another model that includes it. */
export interface FoundModel { path: string; text: string; kind: string; within?: string }

/** Model with the further files for the engine, in base64 by path. */
export interface ModelFiles { name: string; text: string; files?: Record<string, string>; shapes?: (string | null)[] }

const MOST_FILES = 20_000;
/** Largest total size of the files for the engine, bytes: several copies are in memory while a model is opened. */
const LARGEST_TOTAL = 64 * 2 ** 20;
/** Largest size of a model file that the engine reads, bytes. */
const LARGEST_TEXT = 32 * 2 ** 20;
/** Names of files and folders that are skipped: hidden ones, packages of Node.js, and metadata of macOS archives. */
const SKIPPED = /^(\.|node_modules$|__MACOSX$)/;
const ROOTS: Record<string, string> = { robot: 'URDF', mujoco: 'MJCF', sdf: 'SDFormat' };
const MODEL = /\.(urdf|xml|mjcf|sdf|world|toml|json)$/i;
const TEXT = /\.(urdf|xml|mjcf|sdf|world|config|toml|csv|json|sub)$/i;

const base = (path: string) => path.replace(/.*\//, '');

/** Files of a folder that was chosen by an input element. */
export function filesOfInput(list: FileList): NamedFile[] {
  const all = Array.from(list, (file) => ({ path: file.webkitRelativePath || file.name, file }));
  return all.filter(({ path }) => !path.split('/').some((part) => SKIPPED.test(part)));
}

/** Dropped file or folder. */
interface Node { name: string; file?(): Promise<File>; children?(): Promise<Node[]> }

/** Handle of the File System API, which Chromium supports. */
interface Handle { kind: 'file' | 'directory'; name: string; getFile(): Promise<File>; values(): AsyncIterable<Handle> }
type Item = DataTransferItem & { getAsFileSystemHandle?(): Promise<Handle | null> };

/** Dropped files and the files in dropped folders. The items are invalid after the event, so they are read before the first `await`. */
export async function filesOfDrop(data: DataTransfer): Promise<NamedFile[]> {
  const plain = [...data.files].map((file) => ({ path: file.name, file }));
  const items = [...data.items].filter((item) => item.kind === 'file') as Item[];
  const entries = items.map((item) => item.webkitGetAsEntry?.() ?? null);
  if (!entries.some((entry) => entry?.isDirectory)) return plain;
  // In a page opened from a file, Chromium reads folders through handles, but not through entries.
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

/** Name of the format of a model file; `undefined` for other files. */
function kindOf(path: string, text: string): string | undefined {
  if (/\.toml$/i.test(path)) return /^\s*template\s*=/m.test(text) ? 'suspension sheet' : undefined;
  if (/\.json$/i.test(path)) return /"Type"\s*:\s*"Suspension"/.test(text) ? 'Chrono::Vehicle' : undefined;
  const root = /^\uFEFF?\s*(?:<\?[^>]*\?>\s*|<!--[^]*?-->\s*|<![^>]*>\s*)*<([A-Za-z]+)[\s>/]/.exec(text)?.[1];
  return root && ROOTS[root];
}

/** Parts of a text between quotes, angle brackets, slashes and line ends: names of files and folders to which the text may refer. */
function namesIn(text: string): Set<string> {
  return new Set(text.split(/["'<>\n/\\]+/).map((part) => part.trim()));
}

/** Models of a folder; models that another model includes are last. */
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

/** The files of a folder to which a model refers, directly or through other files; `left`: paths of the files beyond the size limit. */
export async function filesOfModel(model: FoundModel, files: NamedFile[]): Promise<{ model: ModelFiles; left: string[] }> {
  const wanted = new Map<string, File>();
  const texts = [model.text];
  for (let text = texts.pop(); text !== undefined; text = texts.pop()) {
    const names = namesIn(text);
    for (const { path, file } of files) {
      if (path === model.path || wanted.has(path)) continue;
      // An <include> of SDFormat can name the folder of a model instead of its file.
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
