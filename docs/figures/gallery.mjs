// Takes the pictures of docs/howto/GALLERY.md: the view of a page of `percuss explore`, the last figure of a report. Needs Chromium, and
// playwright-core as tests/external/explorer/run.sh installs it.
//   node docs/figures/gallery.mjs PAGES   PAGES: the folder that crates/explorer/gallery.sh has written
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const docs = resolve(dirname(fileURLToPath(import.meta.url)), '..');
const { chromium } = createRequire(resolve(docs, '../target/explorer-tests/tests.mjs'))('playwright-core');
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium' });
const page = await browser.newPage({ viewport: { width: 900, height: 640 }, bypassCSP: true });
const devtools = await page.context().newCDPSession(page);
for (const [, file, name] of readFileSync(`${docs}/howto/GALLERY.md`, 'utf8').matchAll(/\.\.\/(figures\/gallery\/\w+\/([\w-]+)\.webp)/g)) {
  await page.goto(String(pathToFileURL(resolve(process.argv[2], `${name}.html`))));
  const figure = page.locator('canvas, svg[role=img]');
  await figure.last().waitFor();
  const isExplorer = (await page.locator('canvas').count()) > 0;
  if (isExplorer) {
    await page.addStyleTag({ content: 'button { visibility: hidden }' });
    await page.waitForTimeout(3000);
  }
  const box = await (isExplorer ? page.locator('canvas').first() : figure.last()).boundingBox();
  const clip = { ...box, scale: Math.min(1, 480 / box.width) };
  const { data } = await devtools.send('Page.captureScreenshot', { format: 'webp', quality: 80, clip, captureBeyondViewport: true });
  mkdirSync(dirname(`${docs}/${file}`), { recursive: true });
  writeFileSync(`${docs}/${file}`, Buffer.from(data, 'base64'));
}
await browser.close();
