// Tests with many gestures: random drags, memory, times of frames.

import assert from 'node:assert/strict';
import { agrees, center, close, explore, launch, open, root, settle, shown } from './harness.mjs';

const SHEET = 'models/suspensions/double-wishbone.toml';
/** Limit of the processor time of the page per result while a hardpoint is dragged, on a processor that is four times as slow, ms. Tested
 * only on an idle machine (`EXPLORER_JUDGE_TIMES=1`, the default of run.sh without `--gate`): other programs that share the caches add a
 * third. */
const LONGEST_FRAME = 60;
const JUDGE_TIMES = process.env.EXPLORER_JUDGE_TIMES === '1';
const SLOWER = 4;
/** Largest distance of the ends of a closed loop, m: loops close to 1e-10 of a size of 1 m, frames have 16 digits. */
const CLOSED = 1e-8;
/** Moves of the pointer in the test of the memory; `EXPLORER_MOVES` overrides the number. */
const MOVES = Number(process.env.EXPLORER_MOVES ?? 10_000);
const PORTIONS = 10;
/** Moves per frame of the browser: more than a user makes, so that the page must drop some of them. */
const MOVES_OF_FRAME = 4;
/** Limit of the growth of the memory over the last four fifths of the moves, bytes: a constant for compiled code and caches of the browser,
 * and 2 kB per result. A reply has 60 kB, so kept replies would exceed the limit. */
const LARGEST_GROWTH = (answers) => 1_500_000 + 2_000 * answers;
/** Least cosine of the rotation of a link from its design position: on the other branch of a loop, a link is turned by more than a right angle. */
const LEAST_COSINE = 0;

/** Seeds of the random drags; `EXPLORER_SEEDS` overrides them. With seed 11, the lower end of the travel becomes unreachable. */
const SEEDS = (process.env.EXPLORER_SEEDS ?? '7,11,23').split(',').map(Number);

/** Browser without WebGL, where software would draw for most of the time: the drags are the same. */
const withoutPictures = () => launch(['--disable-3d-apis', '--disable-gpu']);

/** Page of the sheet in such a browser; three.js reports the missing WebGL on the console. */
async function openWithoutPictures(browser) {
  const page = await open(browser, explore(SHEET, '--at', 'spring'));
  page.bad.splice(0, page.bad.length, ...page.bad.filter((text) => !text.includes('WebGL')));
  await settle(page);
  return page;
}

/** Numerical Recipes, ranqd1: the same drags on every machine. */
function generator(seed) {
  return () => (seed = (seed * 1664525 + 1013904223) % 4294967296) / 4294967296;
}

/** Loops are closed, and no link has jumped to another branch. */
function checkPose({ scene, frames }, what) {
  const at = (link, p) => [0, 1, 2].map((i) => frames[12 * link + 9 + i] + [0, 1, 2].reduce((sum, j) => sum + frames[12 * link + 3 * i + j] * p[j], 0));
  for (const { name, kind, ends } of scene.closures) {
    if (!['spherical', 'revolute', 'fixed', 'universal'].includes(kind)) continue;
    const [a, b] = ends.map(([link, point]) => at(link ?? scene.root, point));
    const gap = Math.hypot(...a.map((x, i) => x - b[i]));
    assert.ok(gap < CLOSED, `${what}: ${name} is open by ${gap} m`);
  }
  scene.links.forEach(({ name, mass }, link) => {
    if (!(mass > 0)) return;
    // Angle between the two rotations: trace of RᵀD is 1 + 2 cos.
    let trace = 0;
    for (let k = 0; k < 9; k++) trace += frames[12 * link + k] * scene.design[12 * link + k];
    assert.ok((trace - 1) / 2 > LEAST_COSINE, `${what}: ${name} is turned by ${Math.acos((trace - 1) / 2)} rad: another branch`);
  });
}

async function randomDrags(drags, seed) {
  const browser = await withoutPictures();
  const page = await openWithoutPictures(browser);
  const random = generator(seed);
  let refused = 0;
  const box = await page.locator('.canvas').boundingBox();
  for (let i = 0; i < drags; i++) {
    const kind = random();
    let from;
    if (kind < 0.7) {
      const circles = await page.$$eval('.points circle:not(.hidden)', (all) => all.map((c) => [c.getAttribute('cx'), c.getAttribute('cy')].map(Number)));
      const [x, y] = circles[Math.floor(random() * circles.length)];
      from = { x: box.x + x, y: box.y + y };
    } else if (kind < 0.85) {
      // The curve: the travel follows the pointer.
      from = await center(page, '.plot');
      from.x += 200 * (random() - 0.5);
    } else {
      // Anywhere: a link, a mark, or the camera.
      from = { x: box.x + box.width * random(), y: box.y + 60 + (box.height - 120) * random() };
    }
    const to = { x: from.x + 60 * (random() - 0.5), y: from.y + 60 * (random() - 0.5) };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x, to.y, { steps: 2 });
    await page.mouse.up();
    await settle(page);
    const state = await page.evaluate(() => {
      const { scene, frames, problem } = window.percussView.state();
      return { frames, problem, scene: { root: scene.root, closures: scene.closures, design: scene.design, links: scene.links.map(({ name, mass }) => ({ name, mass })) } };
    });
    if (state.problem) refused++;
    else checkPose(state, `seed ${seed}, drag ${i + 1}`);
    if (i % 50 === 49) {
      if (!state.problem) await agrees(page, root, `after ${i + 1} drags`);
      // Back to the design, as far as it goes: 50 drags would leave no suspension.
      for (let k = 0; k < 50; k++) await page.keyboard.press('Control+z');
      await page.keyboard.press('0');
      await settle(page);
    }
  }
  console.log(`    ${drags} drags, ${refused} ended without a result`);
  assert.ok(refused < drags / 10, `${refused} of ${drags} drags ended without a result`);
  await close(page);
  await browser.close();
}

export const longTests = (drags) => ({
  ...Object.fromEntries(SEEDS.map((seed) => [`random drags with seed ${seed} leave a page that agrees with the command`, () => randomDrags(drags, seed)])),

  async 'a drag follows the hand on a slow processor'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring'));
    await settle(page);
    const session = await page.context().newCDPSession(page);
    // Processor time of the page: other programs of this machine do not count, nor does the software that draws in place of a graphics
    // processor.
    await session.send('Performance.enable', { timeDomain: 'threadTicks' });
    const spent = async () => (await session.send('Performance.getMetrics')).metrics.find((m) => m.name === 'TaskDuration').value * 1000;
    const from = await center(page, 'circle[data-point=lower_ball]');
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    const rounds = [];
    for (let round = 0; round < 4; round++) {
      await page.evaluate(() => void window.percussView.takeTimes());
      const begun = await spent();
      for (let k = 1; k <= 12; k++) {
        await page.mouse.move(from.x + k, from.y - 2 * k);
        await page.waitForTimeout(30);
      }
      const used = (await spent()) - begun;
      const { count } = await page.evaluate(() => window.percussView.takeTimes());
      assert.ok(count > 2, 'the drag is answered while it lasts');
      rounds.push(used / count);
    }
    await page.mouse.up();
    await settle(page);
    const frame = SLOWER * rounds.sort((a, b) => a - b)[Math.floor(rounds.length / 2)];
    console.log(`    ${frame.toFixed(0)} ms of a processor that is ${SLOWER} times as slow, for each answer`);
    assert.ok(frame > 1, `${frame} ms: no work was measured`);
    if (JUDGE_TIMES) assert.ok(frame < LONGEST_FRAME, `${frame} ms, expected less than ${LONGEST_FRAME}`);
    await close(page);
  },

  async 'the memory is stable over many moves'() {
    const browser = await withoutPictures();
    const page = await openWithoutPictures(browser);
    const session = await page.context().newCDPSession(page);
    const measure = async () => {
      await page.evaluate(() => window.percussView.takeTimes());
      await session.send('HeapProfiler.collectGarbage');
      const { usedSize } = await session.send('Runtime.getHeapUsage');
      return { heap: usedSize, engine: await page.evaluate(() => window.percussView.state().memory), nodes: await page.evaluate(() => document.querySelectorAll('*').length) };
    };
    const from = await center(page, 'circle[data-point=lower_ball]');
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    let first;
    let answers = 0;
    for (let portion = 0; portion < PORTIONS; portion++) {
      // A script in the page creates the events: sent by the test program, they would take ten times as long.
      answers += await page.evaluate(async ([x, y, count, atOnce]) => {
        const surface = document.querySelector('.surface');
        for (let k = 0; k < count; k++) {
          const turn = (2 * Math.PI * k) / count;
          surface.dispatchEvent(new PointerEvent('pointermove', {
            pointerId: 1, pointerType: 'mouse', buttons: 1, bubbles: true, clientX: x + 12 * Math.sin(turn), clientY: y + 9 * Math.sin(3 * turn),
          }));
          if (k % atOnce === 0) await new Promise(requestAnimationFrame);
        }
        return window.percussView.takeTimes().count;
      }, [from.x, from.y, MOVES / PORTIONS, MOVES_OF_FRAME]);
      if (portion === 1) first = await measure();
    }
    const last = await measure();
    assert.ok(answers > MOVES / 50, `${answers} answers to ${MOVES} moves`);
    await page.mouse.up();
    await settle(page);
    console.log(`    ${answers} answers; page ${(last.heap / 1e6).toFixed(1)} MB (${((last.heap - first.heap) / 1e6).toFixed(2)} more), engine ${(last.engine / 1e6).toFixed(1)} MB (${(last.engine - first.engine) / 1e6} more)`);
    assert.ok(last.heap - first.heap < LARGEST_GROWTH(answers), `the page grows by ${last.heap - first.heap} bytes`);
    assert.equal(last.engine, first.engine, 'the engine grows');
    assert.ok(last.nodes <= first.nodes + 10, `${first.nodes} elements, then ${last.nodes}`);
    assert.ok(Number.isFinite(await shown(page)));
    await close(page);
    await browser.close();
  },
});
