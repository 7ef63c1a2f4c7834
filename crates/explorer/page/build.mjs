// Bundles the page in page/dist; needs npm:
//   node build.mjs           writes the bundle
//   node build.mjs --check   builds the bundle again and compares the bytes with page/dist
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = fileURLToPath(new URL('.', import.meta.url));
const work = join(folder, '../../../target/explorer-page');
const [flag] = process.argv.slice(2);
const lock = readFileSync(join(folder, 'package-lock.json'), 'utf8');
const installed = join(work, 'installed.json');
if (!existsSync(installed) || readFileSync(installed, 'utf8') !== lock) {
  mkdirSync(work, { recursive: true });
  for (const name of ['package.json', 'package-lock.json']) cpSync(join(folder, name), join(work, name));
  execFileSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund', '--silent'], { cwd: work, stdio: 'inherit' });
  writeFileSync(installed, lock);
}
const source = join(work, 'page');
rmSync(source, { recursive: true, force: true });
mkdirSync(source);
// Beside node_modules, so that imports are found without settings.
cpSync(join(folder, 'src'), join(source, 'src'), { recursive: true });
cpSync(join(folder, 'tsconfig.json'), join(source, 'tsconfig.json'));
const require = createRequire(join(work, 'package.json'));
const esbuild = require('esbuild');
execFileSync(join(work, 'node_modules/.bin/tsc'), ['-p', source], { stdio: 'inherit' });

const common = { bundle: true, minify: true, write: false, target: 'es2022', charset: 'utf8', legalComments: 'none' };
const worker = await esbuild.build({
  ...common, entryPoints: [join(source, 'src/engine/worker.ts')], format: 'iife',
});
const page = await esbuild.build({
  ...common,
  entryPoints: [join(source, 'src/main.tsx')],
  format: 'iife',
  jsx: 'automatic',
  jsxImportSource: 'preact',
  define: { WORKER_SOURCE: JSON.stringify(worker.outputFiles[0].text) },
});
const style = await esbuild.build({ ...common, entryPoints: [join(source, 'src/page.css')] });
const licences = ['three', 'preact'].map((name) => {
  const { version, license } = JSON.parse(readFileSync(join(work, 'node_modules', name, 'package.json'), 'utf8'));
  return `${name} ${version}, ${license}`;
});
// "</script" inside a script element would end it.
const script = `/* with ${licences.join('; ')} */\n${page.outputFiles[0].text}`.replaceAll('</script', '<\\/script');
const made = { 'page.js': script, 'page.css': style.outputFiles[0].text };
let differs = false;
for (const [name, text] of Object.entries(made)) {
  const path = join(folder, 'dist', name);
  if (flag === '--check') {
    const same = readFileSync(path, 'utf8') === text;
    console.log(`${name}: ${same ? 'as built' : 'differs from the sources: run node crates/explorer/page/build.mjs'}`);
    differs ||= !same;
  } else {
    mkdirSync(join(folder, 'dist'), { recursive: true });
    writeFileSync(path, text);
    console.log(`${name}: ${Buffer.byteLength(text)} bytes`);
  }
}
process.exit(differs ? 1 : 0);
