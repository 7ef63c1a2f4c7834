// Tests of the explorer in a browser: node tests.mjs ROOT [TEST…]

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { agrees, center, close, drag, explore, fileText, folder, join, launch, open, root, settle, shown } from './harness.mjs';
import { contactTests } from './contacts.mjs';
import { folderTests } from './folders.mjs';
import { designTests } from './design.mjs';
import { furtherTests } from './further.mjs';
import { longTests } from './long.mjs';
import { stateTests } from './states.mjs';

const SHEET = 'models/suspensions/double-wishbone.toml';
const SHEETS = join(root, 'models/suspensions');
const models = [
  ...readdirSync(join(root, 'models')).filter((name) => name.endsWith('.urdf')).map((name) => join(root, 'models', name)),
  ...readdirSync(SHEETS).filter((name) => name.endsWith('.toml') && !name.includes('with-table')).map((name) => join(SHEETS, name)),
];

/** Limits of the compressed engine and of the page of a sheet, bytes. */
const LARGEST_ENGINE = 1_450_000;
const LARGEST_PAGE = 2_680_000;
/** Random drags per seed; `EXPLORER_DRAGS` overrides the number. */
const RANDOM_DRAGS = Number(process.env.EXPLORER_DRAGS ?? 350);

/** Compressed engine in a page. */
const engine = (page) => Buffer.from(/id="engine">([^<]*)</.exec(page.toString())[1], 'base64');

const tests = {
  async 'the engine imports nothing'() {
    const module = execFileSync('xz', ['--format=lzma', '-dc'], { input: engine(readFileSync(explore(SHEET))), maxBuffer: 1 << 28 });
    assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(module)), []);
    for (const path of [root, homedir()]) assert.ok(!module.includes(path), `the engine contains ${path}`);
  },

  async 'the page is small'() {
    const page = readFileSync(explore(SHEET));
    console.log(`    engine ${engine(page).length} bytes, page ${page.length} bytes`);
    assert.ok(engine(page).length <= LARGEST_ENGINE && page.length <= LARGEST_PAGE);
  },

  async 'every shipped model has the number of its command'(browser) {
    const page = await open(browser, explore(SHEET));
    let same = 0;
    for (const model of models) {
      await page.setInputFiles('input[type=file]', model);
      await page.waitForFunction((name) => document.querySelector('.file')?.textContent === name && window.percussView.isSettled(), model.replace(/.*\//, ''));
      if (await agrees(page, model.replace(/\/[^/]*$/, ''), model)) same++;
    }
    console.log(`    ${same} of ${models.length} models agree to the last bit`);
    assert.ok(models.length > 30 && same > 0.5 * models.length);
    await close(page);
  },

  async 'a hardpoint is dragged, undone, frozen and linked'(browser) {
    const file = explore(SHEET);
    const page = await open(browser, file);
    await settle(page);
    const first = await shown(page);
    await page.click('button[title^="Keeps the present"]');
    const from = await center(page, 'circle[data-point=lower_ball]');
    await drag(page, from, { x: from.x + 12, y: from.y - 40 });
    const moved = await shown(page);
    assert.notEqual(moved, first);
    await agrees(page, root, 'moved');
    assert.match(await page.textContent('tr.variant .difference'), /[+−]\d/);
    assert.equal(await page.locator('.trace.frozen').count() > 0, true);
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal(await shown(page), first);
    await page.keyboard.press('Control+Shift+z');
    await settle(page);
    assert.equal(await shown(page), moved);
    // The link of the address has the whole state.
    await page.waitForFunction(() => location.hash.length > 100);
    await page.waitForTimeout(400);
    const hash = await page.evaluate(() => location.hash);
    const again = await open(browser, file, {}, hash);
    await settle(again);
    assert.equal(await shown(again), moved);
    await close(again);
    // So has the saved page.
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Save page')]);
    const saved = join(folder, 'saved.html');
    await download.saveAs(saved);
    const third = await open(browser, saved);
    await settle(third);
    assert.equal(await shown(third), moved);
    await close(third);
    await close(page);
  },

  async 'a hardpoint dragged at a travel moves with its link'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring', '--wheel-travel', '40mm'));
    await settle(page);
    const from = await center(page, 'circle[data-point=lower_ball]');
    await drag(page, from, { x: from.x, y: from.y - 30 }, 10);
    const to = await center(page, 'circle[data-point=lower_ball]');
    // The point follows the pointer to the snap of 1 mm, though the move is one of the design position, and the travel of the
    // wheel stays the same.
    assert.ok(Math.hypot(to.x - from.x, to.y - (from.y - 30)) < 14, JSON.stringify([from, to]));
    await agrees(page, root, 'at a travel');
    await close(page);
  },

  async 'the contact and its normal are dragged'(browser) {
    const page = await open(browser, explore('models/shaped_arm.urdf'));
    await settle(page);
    const point = await center(page, '[data-contact=point]');
    await drag(page, point, { x: point.x + 40, y: point.y - 20 });
    await agrees(page, root, 'point');
    const head = await center(page, '[data-contact=normal]');
    await drag(page, head, { x: head.x + 60, y: head.y + 50 });
    await agrees(page, root, 'normal');
    // A click on a link offers the contact there.
    const box = await page.locator('.canvas').boundingBox();
    await page.mouse.click(box.x + box.width * 0.62, box.y + box.height * 0.5);
    if (await page.locator('.picked').count()) {
      await page.click('text=Contact here');
      await agrees(page, root, 'click');
    }
    await page.click('text=+y');
    await agrees(page, root, 'axis');
    await close(page);
  },

  async 'outcomes without a number are explained'(browser) {
    const page = await open(browser, explore('models/four_bar.urdf', '--link', 'coupler', '--point', '0,0,0', '--normal', '0,0,1'));
    await settle(page);
    assert.equal(await shown(page), 'immovable');
    assert.match(await page.textContent('.result'), /Immovable\..*No motion/s);
    await close(page);
    const far = await open(browser, explore(SHEET, '--at', 'spring'));
    await far.fill('[aria-label="wheel travel, mm"]', '900');
    await far.waitForSelector('.box.bad');
    assert.match(await far.textContent('.box.bad'), /reach/);
    await far.click('.box.bad button:has-text("wheel travel to")');
    await settle(far);
    assert.equal(await far.locator('.box.bad').count(), 0);
    await agrees(far, root, 'at the end of the travel');
    await close(far);
  },

  async 'everything is reached by the keyboard'(browser) {
    const page = await open(browser, explore(SHEET));
    await settle(page);
    const first = await shown(page);
    const focused = () => page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.textContent ?? '');
    const seen = new Set();
    const tabThrough = async () => {
      for (let i = 0; i < 130; i++) {
        await page.keyboard.press('Tab');
        seen.add(await focused());
      }
    };
    await tabThrough();
    await page.focus('#tab-result');
    await page.keyboard.press('ArrowRight');
    await tabThrough();
    for (const label of ['Undo', 'wheel travel', 'wheel travel in the curve', 'lower_ball z, mm', 'Copy']) {
      if (label !== 'Undo') assert.ok(seen.has(label), `${label} is reached: ${[...seen].join('; ')}`);
    }
    await page.focus('input[type=range]');
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('Shift+ArrowLeft');
    await settle(page);
    assert.notEqual(await shown(page), first);
    await agrees(page, root, 'slider');
    await page.focus('[aria-label="lower_ball z, mm"]');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Tab');
    await agrees(page, root, 'typed');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press('Control+z');
    await settle(page);
    await page.keyboard.press('f');
    assert.equal(await page.getAttribute('button:has-text("Front")', 'aria-pressed'), 'true');
    await close(page);
  },

  async 'without WebGL there are numbers, curve and lines'() {
    const browser = await launch(['--disable-3d-apis', '--disable-gpu']);
    const page = await open(browser, explore(SHEET));
    page.bad.splice(0, page.bad.length, ...page.bad.filter((text) => !text.includes('WebGL')));
    await settle(page);
    assert.equal(await page.locator('canvas').count(), 0);
    assert.ok((await page.locator('.wires path').count()) > 10);
    assert.ok((await page.getAttribute('.trace.now', 'd')).length > 100);
    await agrees(page, root, 'without WebGL');
    await close(page);
    await browser.close();
  },

  async 'a phone shows it without a horizontal scroll'(browser) {
    const page = await open(browser, explore(SHEET), { viewport: { width: 390, height: 800 }, isMobile: true, hasTouch: true, deviceScaleFactor: 2 });
    await settle(page);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    // Those of closed panels too: a hand meets them later.
    const small = await page.$$eval('button, select, input:not([hidden]):not([type=file])', (all) => all
      .map((e) => [e.textContent || e.getAttribute('aria-label') || e.closest('label')?.textContent, e.getBoundingClientRect()])
      .filter(([, box]) => box.height > 0 && box.height < 36).map(([name]) => name));
    assert.deepEqual(small.filter((name) => name !== 'Close'), []);
    await close(page);
  },

  async 'hostile names stay text'(browser) {
    const name = '</script><img src=x onerror="document.title=1">';
    const escaped = name.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
    const text = fileText('models/planar_2r.urdf').replaceAll(/<robot name="[^"]*"/g, `<robot name="${escaped}"`)
      .replaceAll('"outer"', `"${escaped}"`);
    const path = join(folder, 'hostile.urdf');
    writeFileSync(path, text);
    const page = await open(browser, explore(path.slice(root.length + 1)));
    await settle(page);
    assert.equal(await page.locator('img').count(), 0);
    assert.match(await page.title(), /<img/);
    assert.ok((await page.textContent('.shares')).includes(name), 'the link is named');
    await agrees(page, root, 'a link with a hostile name');
    await close(page);
  },

  async 'a refused file says why, with its line'(browser) {
    const page = await open(browser, explore(SHEET));
    const path = join(folder, 'refused.toml');
    writeFileSync(path, fileText(SHEET).replace(/lower_ball = .*\n/, 'lower_bal = [5.0, 720.0, 180.0]\n'));
    await page.setInputFiles('input[type=file]', path);
    await page.waitForSelector('.refused');
    assert.match(await page.textContent('.refused'), /lower_bal/);
    await page.click('text=Keep the open model');
    await agrees(page, root, 'after a refused file');
    await close(page);
  },

  async 'a study and a table are saved'(browser) {
    const page = await open(browser, explore(SHEET));
    await settle(page);
    const saved = async (button) => {
      const [download] = await Promise.all([page.waitForEvent('download'), page.click(`text=${button}`)]);
      return readFileSync(await download.path(), 'utf8');
    };
    const rows = (await saved('Curve CSV')).trim().split('\n');
    assert.match(rows[0], /^wheel-travel \[m\],status,effective_mass/);
    assert.equal(rows.length, 82);
    assert.match(await saved('Curve SVG'), /^<svg/);
    assert.match(await saved('Changed sheet'), /lower_ball = \[5.0, 720.0, 180.0\]/);
    await page.click('[role=tab]:has-text("Study")');
    assert.match(await page.textContent('pre.text[aria-label=Study]'), /\[contact\]\nat = "bump_stop"/);
    await page.click('[role=tab]:has-text("Command")');
    await close(page);
  },
};

const wanted = process.argv.slice(3);
const browser = await launch();
let failed = 0;
const begun = Date.now();
for (const [name, test] of Object.entries({ ...tests, ...contactTests, ...designTests, ...folderTests, ...furtherTests, ...stateTests, ...longTests(RANDOM_DRAGS) })) {
  if (wanted.length && !wanted.some((word) => name.includes(word))) continue;
  const start = Date.now();
  try {
    await test(browser);
    console.log(`ok    ${name} (${((Date.now() - start) / 1000).toFixed(1)} s)`);
  } catch (error) {
    failed++;
    console.log(`FAIL  ${name}\n${error.stack}`);
  }
}
await browser.close();
console.log(`${failed ? `${failed} failed` : 'all passed'}, ${((Date.now() - begun) / 1000).toFixed(0)} s`);
process.exit(failed ? 1 : 0);
