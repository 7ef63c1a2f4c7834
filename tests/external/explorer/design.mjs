// Tests of the contact cards, axes, keys, touches, variants, targets, sensitivities, the impact in time, hints and the dark page.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { agrees, center, close, drag, explore, fileText, folder, join, json, open, openPanel, openTab, rested, settle, shown, state } from './harness.mjs';

const SHEET = 'models/suspensions/double-wishbone.toml';
const AXLE = 'models/suspensions/solid-axle-panhard.toml';
/** Relative difference between WebAssembly and the native command; amplified rounding errors stay far below. */
const SAME = 1e-9;
/** Relative rounding of the four digits of a card. */
const FOUR_DIGITS = 6e-4;
/** Least ratio of the luminances of a text and its ground: WCAG 2.2, 1.4.3. */
const CONTRAST = 4.5;

const number = (text) => Number(text.replace('−', '-').replace(/[^-0-9.]/g, ''));
const cards = (page) => page.$$eval('[data-contact-name]', (all) => Object.fromEntries(all.map((card) => [card.dataset.contactName, card.querySelector('b').textContent])));
const label = (page, text) => page.locator(`[aria-label="${text}"]`);
/** The page may pause between a change and its computations at rest. */
const listed = (page) => page.waitForFunction(() => !document.querySelector('.card.stale') && window.percussView.isSettled());

/** The sheet in the axes of Adams, whose x is backward and y is right. */
function adamsSheet() {
  const path = join(folder, 'adams.toml');
  const text = fileText(SHEET).replace(/axes = "iso"/, 'axes = "adams"').replace(/side = "left"/, 'side = "right"');
  assert.match(text, /axes = "adams"/);
  writeFileSync(path, text);
  return path;
}

export const designTests = {
  async 'cards have the masses of the present design'(browser) {
    const page = await open(browser, explore(SHEET));
    await openTab(page, 'design');
    await page.fill('[aria-label="lower_ball z, mm"]', '190');
    await page.keyboard.press('Tab');
    await listed(page);
    const moved = (await state(page)).study.model.move.lower_ball;
    const command = json('mass', SHEET, '--at', 'all', '--move', `lower_ball=${moved.join(',')}`);
    const found = await cards(page);
    assert.deepEqual(Object.keys(found), command.contacts.map(({ name }) => name));
    for (const { name, report } of command.contacts) {
      assert.ok(Math.abs(number(found[name]) / report.effective_mass - 1) < FOUR_DIGITS, `${name}: ${found[name]}, ${report.effective_mass} by the command`);
    }
    for (const name of Object.keys(found)) {
      await page.click(`[data-contact-name=${name}]`);
      await agrees(page, join(folder, '../../..'), name);
    }
    await close(page);
  },

  async 'a dragged contact moves no hardpoint'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'bump_stop'));
    await settle(page);
    await rested(page);
    const point = await center(page, '[data-contact=point]');
    const ring = await center(page, 'circle[data-point=bump_stop_pad]');
    assert.ok(Math.hypot(point.x - ring.x, point.y - ring.y) < 1, 'the contact is at a hardpoint');
    await drag(page, point, { x: point.x + 30, y: point.y - 20 });
    const { study } = await state(page);
    assert.equal(study.model.move, undefined);
    assert.equal(study.contact.at, undefined);
    await page.keyboard.press('Control+z');
    // The mechanism returns to the touch.
    await rested(page);
    // The card makes a contact where the next click is; no ring and no link is dragged.
    await page.click('.card.add');
    const at = await center(page, 'circle[data-point=lower_ball]');
    await drag(page, at, { x: at.x + 2, y: at.y });
    const made = (await state(page)).study;
    assert.equal(made.model.move, undefined);
    assert.ok(made.contact.link && !made.contact.at, JSON.stringify(made.contact));
    assert.equal(await page.getAttribute('.card.add', 'aria-pressed'), 'false');
    await close(page);
  },

  async 'all axes are those of the sheet'(browser) {
    const page = await open(browser, explore(adamsSheet()));
    await settle(page);
    // In the view from the front, the triad and a dragged ring have the same y.
    const triad = await page.$$eval('.axes text', (all) => Object.fromEntries(all.map((t) => [t.textContent, Number(t.getAttribute('x'))])));
    const middle = await page.$eval('.axes line', (line) => Number(line.getAttribute('x1')));
    const ring = await center(page, 'circle[data-point=lower_ball]');
    await drag(page, ring, { x: ring.x + 30, y: ring.y });
    const [, y] = (await state(page)).study.model.move.lower_ball;
    assert.equal(Math.sign(y), Math.sign(triad.y - middle), `y ${y}, triad ${JSON.stringify(triad)}`);
    await agrees(page, folder, 'moved in other axes');
    // Point and normal of an own contact.
    await page.keyboard.press('Control+z');
    await rested(page);
    const dot = await center(page, '[data-contact=point]');
    await drag(page, dot, { x: dot.x + 30, y: dot.y });
    const fields = await Promise.all([0, 1, 2].map((k) => page.inputValue(`.line input[aria-label^="point ${'xyz'[k]}"]`)));
    const { scene, study } = await state(page);
    const link = scene.links.findIndex(({ name }) => name === study.contact.link);
    const world = [0, 1, 2].map((i) => scene.design[12 * link + 9 + i] + [0, 1, 2].reduce((sum, j) => sum + scene.design[12 * link + 3 * i + j] * study.contact.point[j], 0));
    fields.forEach((text, k) => assert.ok(Math.abs(Number(text) / 1000 - world[k] * scene.sheet.hardpoints[0].to_world[k]) < 1e-4, `${'xyz'[k]} ${text}`));
    await page.click('.axes button:has-text("+y")');
    await settle(page);
    assert.equal((await state(page)).study.contact.normal[1], scene.sheet.hardpoints[0].to_world[1]);
    await agrees(page, folder, 'a normal along an axis of the sheet');
    await close(page);
  },

  async 'no key step is lost'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring'));
    await settle(page);
    await openTab(page, 'design');
    const point = '[aria-label="lower_ball z, mm"]';
    const before = Number(await page.inputValue(point));
    await page.focus(point);
    // All keys in one task, so that the page is not rendered between them.
    const press = (selector, key, withUp) => page.$eval(selector, (field, [name, up]) => {
      for (let i = 0; i < 10; i++) {
        field.dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true, cancelable: true }));
        if (up) field.dispatchEvent(new KeyboardEvent('keyup', { key: name, bubbles: true }));
      }
    }, [key, withUp]);
    await press(point, 'ArrowUp', false);
    await page.keyboard.press('Tab');
    await settle(page);
    assert.equal(Number(await page.inputValue(point)), before + 10);
    const travel = () => page.inputValue('[aria-label="wheel travel, mm"]').then(Number);
    await press('input[type=range][aria-label="wheel travel"]', 'ArrowRight', false);
    await page.evaluate(() => document.activeElement.blur());
    await page.$eval('input[type=range][aria-label="wheel travel"]', (slider) => slider.dispatchEvent(new KeyboardEvent('keyup', { bubbles: true })));
    await settle(page);
    assert.equal(await travel(), 5);
    await press('.plot', 'ArrowRight', true);
    await settle(page);
    assert.equal(await travel(), 10);
    await close(page);
  },

  async 'the curve has the touches of both stops, also after they have moved'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring'));
    const check = async (flags) => {
      await listed(page);
      await rested(page);
      const marks = await page.$$eval('[data-touch]', (all) => all.map((mark) => [mark.dataset.touch, Number(mark.dataset.travel)]));
      const command = json('mass', SHEET, '--at', 'all', ...flags).contacts.filter(({ kind }) => kind === 'stop');
      assert.deepEqual(marks.map(([name]) => name), command.map(({ name }) => name));
      marks.forEach(([, travel], i) => assert.ok(Math.abs(travel - command[i].report.named_contact.wheel_travel[0].travel) < SAME, `${travel}`));
      const [low, high] = await page.$eval('.plot', (plot) => [Number(plot.ariaValueMin), Number(plot.ariaValueMax)]);
      for (const [, travel] of marks) assert.ok(travel * 1000 > low && travel * 1000 < high, `${travel} in ${low} to ${high}`);
      return high;
    };
    const first = await check([]);
    // Nearer to the hinge, the pad needs a longer travel.
    await openTab(page, 'design');
    await page.fill('[aria-label="bump_stop_pad y, mm"]', '525');
    await page.keyboard.press('Tab');
    await settle(page);
    const moved = (await state(page)).study.model.move.bump_stop_pad;
    assert.ok(await check(['--move', `bump_stop_pad=${moved.join(',')}`]) > first, 'the range follows');
    await close(page);
  },

  async 'every warning of the command is beside the result'(browser) {
    for (const flags of [['--at', 'spring', '--wheel-travel=75mm'], ['--at', 'damper', '--wheel-travel=-100mm']]) {
      const page = await open(browser, explore(SHEET, ...flags));
      await settle(page);
      const warnings = json('mass', SHEET, ...flags).diagnostics.filter(({ severity }) => severity === 'warning');
      const texts = await page.$$eval('.side > section:nth-of-type(2) .finding', (all) => all.map((finding) => finding.textContent));
      assert.ok(warnings.length > 0, flags.join(' '));
      for (const { message } of warnings) assert.ok(texts.some((text) => text.includes(message)), `${message} in ${texts.join('; ')}`);
      await close(page);
    }
  },

  async 'variants have colours and a table'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring'));
    await settle(page);
    await openTab(page, 'design');
    const masses = [await shown(page)];
    for (const z of [185, 190]) {
      await page.click('button[title^="Keeps the present"]');
      await page.fill('[aria-label="lower_ball z, mm"]', String(z));
      await page.keyboard.press('Tab');
      await settle(page);
      masses.push(await shown(page));
    }
    const colours = await page.$$eval('.trace.frozen', (all) => all.map((path) => getComputedStyle(path).stroke));
    assert.equal(new Set(colours).size, 2, colours.join());
    const rows = await page.$$eval('tr.variant', (all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
    rows.forEach(([name, mass, by], i) => {
      assert.ok(name.startsWith('AB'[i]) && Math.abs(number(mass) / masses[i] - 1) < FOUR_DIGITS, `${name} ${mass}`);
      assert.ok(Math.abs(number(by) - (masses[2] - masses[i])) <= 0.05 + 1e-9, `${by}, ${masses[2] - masses[i]}`);
    });
    await page.click('[aria-label="Remove variant A"]');
    assert.equal(await page.locator('tr.variant').count(), 1);
    await close(page);
  },

  async 'both stops have a mass of their own, and the curve keeps the roll'(browser) {
    const page = await open(browser, explore(AXLE, '--at', 'bump_stop_left'));
    await settle(page);
    const together = json('mass', AXLE, '--at', 'bump_stop_left').named_contact.effective_mass_together;
    assert.ok(Math.abs(number(await page.textContent('.both b')) / together - 1) < FOUR_DIGITS);
    await page.click('[data-contact-name=spring_left]');
    await settle(page);
    for (const [name, value] of [['heave', '10'], ['roll', '15']]) {
      await page.fill(`[aria-label="${name}, mm"]`, value);
      await page.keyboard.press('Tab');
    }
    await agrees(page, join(folder, '../../..'), 'heave and roll');
    const { values, curve } = await state(page);
    assert.deepEqual([values.heave, values.roll], [0.01, 0.015]);
    const rows = curve.ok.rows.filter(({ mass }) => mass !== null);
    const i = rows.findIndex(({ at }) => at > 0.01);
    const [a, b] = [rows[i - 1], rows[i]];
    const between = a.mass + ((b.mass - a.mass) * (0.01 - a.at)) / (b.at - a.at);
    // Linear interpolation between two rows: their difference is the error bound.
    assert.ok(Math.abs(between - (await shown(page))) <= Math.abs(b.mass - a.mass) + 1e-6, `${between}`);
    await close(page);
  },

  async 'the mass with a free chassis is beside the mass with a fixed one'(browser) {
    const path = join(folder, 'chassis.toml');
    writeFileSync(path, `${fileText(SHEET)}\n[chassis]\nmass = 400\ncom = [0, 0, 400]\ninertia = [40, 200, 220]\n`);
    const page = await open(browser, explore(path, '--at', 'bump_stop'));
    await settle(page);
    const { other_base: other } = json('mass', path, '--at', 'bump_stop');
    const text = await page.locator('.result p:has-text("With the chassis free") b').textContent();
    assert.ok(Math.abs(number(text) / other.effective_mass - 1) < FOUR_DIGITS, `${text}, ${other.effective_mass} by the command`);
    // The mass of the fixed chassis is no part of the mechanism that strikes.
    assert.match(await page.textContent('.result'), /mechanism of 40\.75 kg/);
    await close(page);
  },

  async 'a target is solved for, and the largest rates are listed'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'bump_stop'));
    await settle(page);
    const first = await shown(page);
    await page.waitForSelector('.tornado tr');
    const { most_per_kilogram: most } = json('mass', SHEET, '--at', 'bump_stop', '--explain').explanation;
    assert.ok((await page.textContent('.side')).includes(most[0].link.replaceAll('_', ' ')));
    await page.click('.tornado tr:first-child button');
    // The picture follows with the next frame.
    await page.waitForFunction(() => document.querySelectorAll('.points circle.selected').length === 1);
    await page.fill('.target-search input >> nth=0', String((first - 5).toFixed(3)));
    await page.selectOption('.target-search select', 'bump_stop_pad.y');
    await page.click('.target-search button');
    await page.waitForFunction(() => /Changed/.test(document.querySelector('.told')?.textContent ?? ''));
    await agrees(page, join(folder, '../../..'), 'the target');
    // The page rounds a move to 0.1 µm, at some kg per mm.
    assert.ok(Math.abs((await shown(page)) - Number((first - 5).toFixed(3))) < 1e-3, String(await shown(page)));
    const solved = await shown(page);
    await page.fill('.target-search input >> nth=0', '1');
    await page.click('.target-search button');
    await page.waitForFunction(() => /Not reached/.test(document.querySelector('.told')?.textContent ?? ''));
    assert.equal(await shown(page), solved);
    await close(page);
  },

  async 'an impact in time is played with its forces'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'bump_stop'));
    await settle(page);
    await openPanel(page, 'impact');
    await page.fill('details.impact input >> nth=2', '200 N/mm');
    await page.check('details.impact input[type=checkbox]');
    await page.waitForSelector('.moments');
    await rested(page);
    const time = (await state(page)).results.impact.ok.in_time;
    const command = JSON.parse(execFileSync('bash', ['-c', `${(await page.textContent('details.impact .command pre')).replace(/^percuss/, '"$PERCUSS"')} --format json 2>/dev/null`], { cwd: join(folder, '../../..'), encoding: 'utf8', maxBuffer: 1 << 28 }));
    assert.ok(Math.abs(time.peak_force / command.in_time.peak_force - 1) < SAME);
    const length = () => page.$$eval('.impulses g', (all) => {
      const line = all.find((g) => g.dataset.impulse.startsWith('contact'))?.querySelector('line');
      return line ? Math.hypot(line.x2.baseVal.value - line.x1.baseVal.value, line.y2.baseVal.value - line.y1.baseVal.value) : 0;
    });
    const moment = async (i) => {
      await page.$eval('[aria-label="time of the impact"]', (slider, at) => {
        slider.value = at;
        slider.dispatchEvent(new Event('input', { bubbles: true }));
      }, i);
      await page.waitForTimeout(100);
      assert.equal(Number(await page.getAttribute('.moments [data-force]', 'data-force')), time.force[i]);
      return length();
    };
    const peak = time.force.indexOf(Math.max(...time.force));
    const [most, less] = [await moment(peak), await moment(Math.round(time.force.length * 0.9))];
    assert.ok(most > less + 5, `arrows of ${most} and ${less} pixels`);
    await page.click('[aria-label=Play]');
    await page.waitForSelector('[aria-label=Pause]');
    await page.waitForTimeout(500);
    assert.ok(Number(await page.inputValue('[aria-label="time of the impact"]')) < time.force.length - 1);
    await page.click('[aria-label=Pause]');
    await close(page);
  },

  async 'three hints vanish as they are done'(browser) {
    const page = await open(browser, explore(SHEET));
    await settle(page);
    assert.equal(await page.locator('.hints span').count(), 3);
    await page.click('[data-contact-name=damper]');
    await settle(page);
    assert.equal(await page.locator('.hints .done').count(), 1);
    const ring = await center(page, 'circle[data-point=lower_ball]');
    await drag(page, ring, { x: ring.x + 10, y: ring.y - 20 });
    assert.equal(await page.locator('.hints .done').count(), 2);
    await page.click('button[title^="Keeps the present"]');
    assert.equal(await page.locator('.hints').count(), 0);
    await close(page);
  },

  async 'a dark page has contrast, and a light saved figure'(browser) {
    for (const colorScheme of ['light', 'dark']) {
      const page = await open(browser, explore(SHEET), { colorScheme });
      await rested(page);
      const least = await page.evaluate(() => {
        const luminance = (text) => {
          const [r, g, b] = text.match(/[\d.]+/g).slice(0, 3).map((x) => x / 255).map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
          return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const ground = (element) => {
          for (let at = element; at; at = at.parentElement) {
            const colour = getComputedStyle(at).backgroundColor;
            if (!/, 0\)$|transparent/.test(colour)) return colour;
          }
          return 'rgb(255, 255, 255)';
        };
        const texts = [...document.querySelectorAll('.side *, .bar *, .cards *, .hints *, .curve-head *')]
          .filter((e) => [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim()) && !e.closest(':disabled, option, .stale'));
        const ratios = texts.map((e) => {
          const [a, b] = [luminance(getComputedStyle(e).color), luminance(ground(e))].sort((x, y) => y - x);
          return { ratio: (a + 0.05) / (b + 0.05), text: `${e.className} ${e.textContent.slice(0, 30)}` };
        });
        return ratios.filter(({ text }) => !text.startsWith('done')).sort((a, b) => a.ratio - b.ratio)[0];
      });
      assert.ok(least.ratio >= CONTRAST, `${colorScheme}: ${least.ratio} of ${least.text}`);
      const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Curve SVG')]);
      const svg = execFileSync('cat', [await download.path()], { encoding: 'utf8' });
      assert.match(svg, /stroke="rgb\(184, 58, 15\)"/);
      await close(page);
    }
  },
};
