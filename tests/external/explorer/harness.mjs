// Browser, pages and the command for the tests.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { dirname, isAbsolute, join } from 'node:path';
import { chromium } from 'playwright-core';

export const root = process.argv[2];
const program = process.env.PERCUSS;
export const folder = join(root, 'target/explorer-tests/pages');
mkdirSync(folder, { recursive: true });

const GL = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** Output of the command in the root of the project. */
export function percuss(...args) {
  return execFileSync(program, args, { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28 });
}

export const json = (...args) => JSON.parse(percuss(...args, '--format', 'json'));

/** Questions, results and values of the page. */
export const state = (page) => page.evaluate(() => window.percussView.state());

/** Longest work that a drag leaves out, ms: a map of 40,000 facets on a machine that compiles at the same time. */
const LONGEST_REST = 60_000;

/** Waits until the work is done that a drag leaves out. */
export async function rested(page) {
  const late = new Promise((_, reject) => setTimeout(() => reject(new Error('the page does not come to rest')), LONGEST_REST).unref());
  await Promise.race([page.evaluate(() => window.percussView.rested()), late]);
}

export async function launch(extra = GL) {
  return chromium.launch({ executablePath: process.env.CHROMIUM, args: extra.includes('--no-sandbox') ? extra : ['--no-sandbox', ...extra] });
}

/** Page of a model, written by the command. */
export function explore(model, ...flags) {
  const output = join(folder, `${model.replace(/.*\//, '')}.html`);
  execFileSync(program, ['explore', isAbsolute(model) ? model : join(root, model), ...flags, '-o', output, '--force'], { stdio: ['ignore', 'ignore', 'pipe'] });
  return output;
}

/** Opens a page and watches it: nothing may be requested, refused by the policy, thrown or written to the console. */
export async function open(browser, file, options = {}, hash = '') {
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, acceptDownloads: true, ...options });
  const page = await context.newPage();
  const bad = [];
  page.on('console', (message) => {
    // Messages of the graphics driver, which SwiftShader writes about its own speed.
    if (!message.text().includes('GL Driver Message')) bad.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => bad.push(`exception: ${error.stack}`));
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) bad.push(`request: ${request.url()}`);
  });
  await page.addInitScript(() => {
    addEventListener('securitypolicyviolation', (event) => console.log('policy', event.violatedDirective, event.blockedURI));
  });
  page.bad = bad;
  await page.goto(`file://${file}${hash}`);
  await page.waitForFunction(() => document.querySelector('[data-mass]') && window.percussView);
  return page;
}

export async function close(page) {
  assert.deepEqual(page.bad, [], 'the page is silent');
  await page.context().close();
}

/** m̄ shown, or the outcome. */
export async function shown(page) {
  const text = await page.getAttribute('[data-mass]', 'data-mass');
  return Number.isNaN(Number(text)) ? text : Number(text);
}

/** Tab of each panel. */
const TABS = { kinematics: 'kinematics', safe: 'safe', impact: 'impact', damper: 'impact' };

export const openTab = (page, tab) => page.click(`#tab-${tab}`);

/** Turns to the tab of a panel and waits for its result. */
export async function openPanel(page, kind) {
  await openTab(page, TABS[kind]);
  await page.waitForFunction((name) => window.percussView.state().results[name], kind);
}

/** Waits until the page has answered all changes. */
export async function settle(page) {
  try {
    await page.waitForFunction(() => window.percussView.isSettled());
  } catch (error) {
    const busy = await page.evaluate(() => document.querySelector('.bar')?.textContent).catch(() => 'no answer of the page');
    throw new Error(`${error.message}: ${busy}; ${page.bad.join('; ')}`);
  }
}

/** Executes the command that the page shows, as a shell does, and returns m̄ or the outcome. */
export async function executed(page, cwd) {
  const command = await page.textContent('pre.text[aria-label=Command]');
  assert.match(command, /^percuss mass /);
  const text = execFileSync('bash', ['-c', `${command.replace(/^percuss/, '"$PERCUSS"')} --format json 2>/dev/null`], { cwd, encoding: 'utf8' });
  const report = JSON.parse(text);
  return { mass: report.effective_mass ?? report.status, error: report.effective_mass_error ?? 0 };
}

export async function center(page, selector) {
  const mark = page.locator(selector).first();
  // The picture follows with the next frame.
  await mark.waitFor();
  const box = await mark.boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

export async function drag(page, from, to, steps = 6) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps });
  await page.mouse.up();
  await settle(page);
}

/** The number shown is that of the command: both within their stated errors, for the last bits of a position differ between processors. */
export async function agrees(page, cwd, what) {
  await settle(page);
  const [here, there] = [await shown(page), await executed(page, cwd)];
  if (typeof here === 'number' && typeof there.mass === 'number') {
    assert.ok(Math.abs(here - there.mass) <= 2 * there.error, `${what}: ${here} here, ${there.mass} ± ${there.error} by the command`);
  } else {
    assert.equal(here, there.mass, what);
  }
  return here === there.mass;
}

export const fileText = (path) => readFileSync(join(root, path), 'utf8');
export { dirname, join };
