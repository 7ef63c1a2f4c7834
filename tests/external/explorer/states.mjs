// Appearance of pages, reports and figures: each state is compared with its recorded picture of few grey cells, and its geometry is checked.
// EXPLORER_RECORD=1 writes states.json; the pictures at full size, to look at, are in target/explorer-tests/states.

import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { explore, folder, join, open, percuss, rested, root, settle } from './harness.mjs';

const RECORD = join(root, 'tests/external/explorer/states.json');
const PICTURES = join(folder, '../states');
/** Cells of a recorded picture, and its levels of grey. */
const [COLUMNS, ROWS, LEVELS] = [40, 30, 36];
/** Largest mean difference, levels: another version of the browser smooths glyphs differently. */
const MEAN = 0.4;
/** Largest difference of a cell, levels: a third of the range, such as a bar or a panel that is missing. */
const CELL = 12;
/** Cells with more than a sixth of the range may be this share of all: a line of text that moves changes a row of cells. */
const [CHANGED, SHARE] = [6, 0.02];
/** Largest overlap of two texts of a figure, share of the smaller one: boxes include the space above capitals. */
const OVERLAP = 0.35;

const SHEETS = 'models/suspensions';
const DESKTOP = { width: 1440, height: 900 };
const PHONE = { width: 390, height: 844 };
const PAPER = { width: 794, height: 1123 };
const STOP = [`${SHEETS}/double-wishbone.toml`, '--at', 'bump_stop'];
const FOUR_BAR = ['models/four_bar.urdf', '--link', 'coupler', '--point', '0.35,0.1,0', '--normal', '0,1,0'];
const ARM = ['models/six_r_arm.urdf', '--link', 'tool', '--point', '0.08,0,0', '--normal', '0,0,-1', '--normal-frame', 'world', '--set', 'shoulder=-40deg'];

const PAGES = {
  wishbone: STOP,
  strut: [`${SHEETS}/macpherson-strut.toml`, '--at', 'spring'],
  links: [`${SHEETS}/five-link.toml`, '--at', 'bump_stop'],
  rocker: [`${SHEETS}/pushrod-rocker.toml`, '--at', 'bump_stop'],
  axle: [`${SHEETS}/solid-axle-watt.toml`],
  linkage: FOUR_BAR,
  arm: ARM,
};
/** Parts of the page of a sheet, with the clicks that open them. */
const PARTS = {
  kinematics: ['#tab-kinematics'],
  impact: ['#tab-impact'],
  damper: ['#tab-impact', 'details.impact > summary'],
  masses: ['#tab-design', 'summary:has-text("Masses and moments")'],
  study: ['[role=tab]:has-text("Study")'],
};
const STUDIES = ['report', 'variants', 'bump-stop-impact', 'arm-impact', 'extremes', 'reflected-inertia', 'percussion', 'feet-impact', 'four-bar-impact'];
const FIGURES = {
  travel: ['sweep', ...STOP, '--vary', 'wheel-travel=-80mm:80mm:41', '--unit', 'mm'],
  linkage: ['sweep', ...FOUR_BAR, '--vary', 'crank_hinge=0deg:360deg:181'],
  arm: ['sweep', ...ARM, '--vary', 'elbow=0deg:110deg:45'],
  grid: ['sweep', ...ARM.slice(0, -2), '--vary', 'shoulder=-60deg:20deg:5', '--vary', 'elbow=0deg:110deg:23'],
  designs: ['compare', STOP[0], `${SHEETS}/multi-link.toml`, `${SHEETS}/macpherson-strut.toml`, '--at', 'spring', '--vary', 'wheel-travel=-60mm:60mm:31'],
  map: ['map', 'models/shaped_arm.urdf', '--link', 'finger'],
  kinematics: ['kinematics', STOP[0], '--wheel-travel=-80mm:80mm:41'],
  damp: ['damp', '--mass-from', ...STOP, '--stiffness', '200000', '--restitution', '0.3', '--speed', '0.5'],
  time: ['impact', ...STOP, '--in-time', '--stiffness', '200000', '--restitution', '0.3', '--speed', '0.5'],
  response: ['response', `${SHEETS}/double-wishbone-bushes.toml`, '--at', 'bump_stop'],
};

/** Texts of a picture that cover each other, and texts beyond its frame. */
const faults = (page) => page.evaluate((most) => {
  const bad = [];
  const name = (text) => text.textContent.trim().slice(0, 30);
  if (document.documentElement.scrollWidth > document.documentElement.clientWidth + 1) bad.push(`wider than the window: ${document.documentElement.scrollWidth}`);
  for (const svg of document.querySelectorAll('svg[role=img], body > svg, svg:root')) {
    const frame = svg.getBoundingClientRect();
    const texts = [...svg.querySelectorAll('text')].filter((text) => text.textContent.trim() && text.checkVisibility());
    const boxes = texts.map((text) => text.getBoundingClientRect());
    boxes.forEach((a, i) => {
      const upright = a.width > a.height;
      if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.top < frame.top - 1 || a.bottom > frame.bottom + 1) bad.push(`outside: ${name(texts[i])}`);
      for (let j = 0; j < i; j++) {
        const b = boxes[j];
        if ((b.width > b.height) !== upright) continue;
        const [w, h] = [Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)];
        if (w > 0 && h > 0 && w * h > most * Math.min(a.width * a.height, b.width * b.height)) bad.push(`${name(texts[j])} / ${name(texts[i])}`);
      }
    });
  }
  return bad;
}, OVERLAP);

/** Grey cells of a picture, a character each. */
async function cells(eye, png) {
  return eye.evaluate(async ([data, columns, rows, levels]) => {
    const picture = new Image();
    picture.src = `data:image/png;base64,${data}`;
    await picture.decode();
    const canvas = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
    canvas.drawImage(picture, 0, 0);
    const { data: pixels } = canvas.getImageData(0, 0, picture.width, picture.height);
    let text = '';
    for (let r = 0; r < rows; r++) {
      for (let c = 0; c < columns; c++) {
        const [x0, x1] = [c, c + 1].map((k) => Math.round((k * picture.width) / columns));
        const [y0, y1] = [r, r + 1].map((k) => Math.round((k * picture.height) / rows));
        let sum = 0;
        for (let y = y0; y < y1; y++) for (let x = x0; x < x1; x++) for (let k = 0; k < 3; k++) sum += pixels[4 * (y * picture.width + x) + k];
        text += Math.min(levels - 1, Math.floor((sum / (3 * 255 * (x1 - x0) * (y1 - y0))) * levels)).toString(levels);
      }
    }
    return text;
  }, [png.toString('base64'), COLUMNS, ROWS, LEVELS]);
}

function difference(found, expected) {
  const level = (text) => [...text].map((c) => parseInt(c, LEVELS));
  const there = level(expected);
  const by = level(found).map((value, k) => Math.abs(value - there[k]));
  const mean = by.reduce((a, b) => a + b) / by.length;
  const share = by.filter((value) => value > CHANGED).length / by.length;
  return { mean, cell: Math.max(...by), share, looksEqual: mean <= MEAN && Math.max(...by) <= CELL && share <= SHARE };
}

/** All states: name → function that opens the state and returns its page. */
function states(browser) {
  const all = {};
  const explorer = (name, flags, options, act = () => {}) => {
    all[`page ${name}`] = async () => {
      const page = await open(browser, explore(...flags), options);
      await settle(page);
      // The parts of the panel keep their places after that.
      await rested(page);
      await act(page);
      await settle(page);
      await rested(page);
      return page;
    };
  };
  for (const [name, flags] of Object.entries(PAGES)) {
    explorer(name, flags, { viewport: DESKTOP });
    explorer(`${name}, dark`, flags, { viewport: DESKTOP, colorScheme: 'dark' });
    explorer(`${name}, phone`, flags, { viewport: PHONE });
  }
  for (const [part, clicks] of Object.entries(PARTS)) {
    const shown = async (page) => {
      for (const selector of clicks) await page.click(selector);
      await page.locator(clicks.at(-1)).scrollIntoViewIfNeeded();
    };
    explorer(`wishbone, ${part}`, STOP, { viewport: DESKTOP }, shown);
    explorer(`wishbone, ${part}, phone`, STOP, { viewport: PHONE }, shown);
  }
  const file = (name, write, viewport, media) => {
    all[name] = async () => {
      const page = await browser.newPage({ viewport });
      page.bad = [];
      if (media) await page.emulateMedia({ media });
      await page.goto(`file://${write()}`);
      return page;
    };
  };
  for (const study of STUDIES) {
    const write = () => {
      const output = join(folder, `${study}.report.html`);
      if (!existsSync(output)) percuss('run', `models/studies/${study}.toml`, '--report', output, '--allow-outside');
      return output;
    };
    file(`report ${study}`, write, { width: 1200, height: 900 });
    file(`report ${study}, phone`, write, { width: 360, height: 800 });
    file(`report ${study}, paper`, write, PAPER, 'print');
  }
  for (const [figure, words] of Object.entries(FIGURES)) {
    const write = () => {
      const output = join(folder, `${figure}.svg`);
      rmSync(output, { force: true });
      percuss(...words, '--output', output);
      return output;
    };
    file(`figure ${figure}`, write, { width: 1000, height: 900 });
  }
  return all;
}

export const stateTests = {
  async 'states look as recorded'(browser) {
    mkdirSync(PICTURES, { recursive: true });
    const recorded = existsSync(RECORD) ? JSON.parse(readFileSync(RECORD, 'utf8')) : {};
    const eye = await browser.newPage();
    const [found, bad] = [{}, []];
    for (const [name, show] of Object.entries(states(browser))) {
      const page = await show();
      const png = await page.screenshot({ path: join(PICTURES, `${name.replace(/[, ]+/g, '-')}.png`), animations: 'disabled' });
      for (const fault of await faults(page)) bad.push(`${name}: ${fault}`);
      await page.close();
      found[name] = await cells(eye, png);
      const { mean, cell, share, looksEqual } = difference(found[name], recorded[name] ?? ''.padEnd(COLUMNS * ROWS, '0'));
      if (!looksEqual && !process.env.EXPLORER_RECORD) bad.push(`${name}: mean ${mean.toFixed(2)}, cell ${cell}, changed ${(100 * share).toFixed(1)} %; EXPLORER_RECORD=1 records the pictures again`);
    }
    await eye.close();
    if (process.env.EXPLORER_RECORD) writeFileSync(RECORD, `${JSON.stringify(found, null, 1)}\n`);
    console.log(`    ${Object.keys(found).length} states`);
    assert.deepEqual(Object.keys(recorded).filter((name) => !(name in found)), [], 'states that are recorded only');
    assert.deepEqual(bad, []);
  },
};
