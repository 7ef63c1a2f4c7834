// Tests of studies, further results, dragged links, bands, maps and hostile texts.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { agrees, center, close, explore, fileText, folder, join, json, open, openPanel, openTab, percuss, rested, root, settle, shown, state } from './harness.mjs';

const SHEET = 'models/suspensions/double-wishbone.toml';
/** Relative difference of numbers that two processors compute: some thousand roundings, and steps of an iteration that ends at 1e-12. */
const SAME = 1e-9;
/** Distance of a dragged point from the pointer, pixels: half of the step of the driver, and a last step that a drag does not take. */
const FOLLOWS = 12;

function same(here, there, what) {
  assert.ok(typeof here === 'number' && typeof there === 'number', `${what}: ${here} here, ${there} by the command`);
  assert.ok(Math.abs(here - there) <= SAME * Math.max(Math.abs(here), Math.abs(there)), `${what}: ${here} here, ${there} by the command`);
}

const result = async (page, kind) => {
  await rested(page);
  const found = (await state(page)).results[kind];
  assert.ok(found?.ok, `${kind}: ${JSON.stringify(found)?.slice(0, 300)}`);
  return found.ok;
};

/** Flags of a contact at a named place. */
const at = ['--at', 'spring', '--wheel-travel=20mm'];

export const furtherTests = {
  async 'a study opens with its contact, pose and variants'(browser) {
    const study = 'models/studies/variants.toml';
    const page = await open(browser, explore(study));
    await rested(page);
    const report = json('compare', study);
    const buttons = await page.$$eval('.variant button:first-child', (all) => all.map((b) => b.textContent));
    assert.deepEqual(buttons, ['lighter upright', 'ball 5 mm higher', 'stop further out']);
    const designs = report.designs ?? report.rows ?? [];
    const masses = designs.map((design) => design.effective_mass ?? design.mass?.effective_mass);
    same(await shown(page), masses[0], 'the design of the study');
    for (const [i, name] of buttons.entries()) {
      await page.click(`.variant button:has-text("${name}")`);
      await settle(page);
      same(await shown(page), masses[i + 1], name);
    }
    await agrees(page, root, 'the last variant');
    await close(page);
    // Flags and a study exclude each other, and what the page cannot show is refused with a remedy.
    assert.match(refused('explore', study, '--at', 'spring'), /remove the\s+flags/);
    const closure = join(folder, 'closure.toml');
    writeFileSync(closure, `[model]\npath = "${join(root, 'models/four_bar.urdf')}"\n[[closure]]\nname = "c"\nkind = "distance"\nends = [{ link = "crank", point = [0, 0, 0] }, { link = "rocker", point = [0, 0, 0] }]\n`);
    assert.match(refused('explore', closure), /closure/);
  },

  async 'the report links to the explorer and has no script'(browser) {
    const report = join(folder, 'a report.html');
    percuss('run', 'models/studies/variants.toml', '--report', report, '--explorer', join(folder, 'its page.html'), '--allow-outside', '--force');
    const text = readFileSync(report, 'utf8');
    assert.ok(!/<script/i.test(text) && text.includes("default-src 'none'"));
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.goto(`file://${encodeURI(report)}`);
    await page.click('text=in the explorer');
    await page.waitForSelector('[data-mass]');
    await page.waitForFunction(() => window.percussView.isSettled());
    same(await shown(page), json('compare', 'models/studies/variants.toml').designs[0].effective_mass, 'the page of the report');
    await context.close();
  },

  async 'damper, impact and safe speed are those of the commands'(browser) {
    const page = await open(browser, explore(SHEET, ...at));
    await openPanel(page, 'damper');
    const damper = await result(page, 'damper');
    const command = json('damp', '--mass-from', SHEET, ...at, '--restitution', '0.3', '--stiffness', '200N/mm', '--speed', '1m/s', '--for', 'mujoco');
    for (const key of ['damping', 'peak_force', 'max_penetration', 'contact_duration']) same(damper[key], command[key], key);
    assert.match(await page.textContent('.simulator pre'), /solref/);
    // The last digits differ between processors.
    const numbers = (text) => text.match(/[-0-9.]+(e-?[0-9]+)?/g).map(Number).filter(Number.isFinite);
    const [here, there] = [damper, command].map((report) => numbers(report.exports.mujoco.snippet));
    assert.equal(here.length, there.length);
    here.forEach((x, i) => same(x, there[i], damper.exports.mujoco.snippet));
    // Another law, with a unit in words that the engine does not know: refused with the reason.
    await page.fill('details.damper input >> nth=1', '200 stones');
    await page.keyboard.press('Tab');
    await rested(page);
    assert.match(await page.textContent('details.damper .box'), /stones|unit/);
    await page.fill('details.damper input >> nth=1', '100 N/mm');
    await page.keyboard.press('Tab');
    same((await result(page, 'damper')).damping, json('damp', '--mass-from', SHEET, ...at, '--restitution', '0.3', '--stiffness', '100N/mm', '--speed', '1m/s').damping, 'softer');
    await openPanel(page, 'impact');
    const impact = await result(page, 'impact');
    const other = json('impact', SHEET, ...at, '--restitution', '0.3', '--speed', '1m/s');
    same(impact.impulse, other.impulse, 'impulse');
    assert.equal(impact.reactions.length, other.reactions.length);
    const arrows = await page.$$eval('.impulses [data-impulse]', (all) => all.map((a) => a.dataset.impulse));
    assert.ok(arrows.length > 5 && arrows.some((name) => name.startsWith('contact:')), arrows.join('; '));
    await close(page);
    const arm = await open(browser, explore('models/six_r_arm.urdf', '--link', 'tool', '--point', '0.08,0,0', '--normal', '0,0,-1'));
    await openPanel(arm, 'safe');
    await rested(arm);
    assert.match(await arm.textContent('details.safe'), /Give the limit/);
    await arm.fill('details.safe input >> nth=0', '140 N');
    await arm.keyboard.press('Tab');
    const [safe] = await result(arm, 'safe');
    const speeds = json('safe-speed', 'models/six_r_arm.urdf', '--link', 'tool', '--point', '0.08,0,0', '--normal', '0,0,-1', '--region', 'chest', '--force', '140');
    same(safe.reflected.speed, (Array.isArray(speeds) ? speeds[0] : speeds).reflected.speed, 'safe speed');
    await close(arm);
  },

  async 'camber and toe follow the travel and the design'(browser) {
    const page = await open(browser, explore(SHEET, ...at));
    await openPanel(page, 'kinematics');
    const check = async (...flags) => {
      const { rows: [here] } = await result(page, 'kinematics');
      const there = json('kinematics', SHEET, ...flags).rows[0];
      for (const key of ['camber', 'toe', 'caster', 'half_track_change']) {
        assert.ok(Math.abs(here[key] - there[key]) < SAME, `${key}: ${here[key]} here, ${there[key]} by the command`);
      }
      return here.camber;
    };
    const first = await check('--wheel-travel=20mm');
    const onPage = Number(await page.getAttribute('[data-quantity=camber]', 'data-value'));
    assert.equal(onPage, first);
    await page.click('button[title^="Keeps the present"]');
    await openTab(page, 'design');
    await page.fill('[aria-label="upper_ball y, mm"]', String(Number(await page.inputValue('[aria-label="upper_ball y, mm"]')) - 5));
    await page.keyboard.press('Tab');
    await openPanel(page, 'kinematics');
    assert.notEqual(await check('--wheel-travel=20mm', '--move=upper_ball=0,-5mm,0'), first);
    assert.match(await page.textContent('details.kinematics thead'), /Δ A/);
    await close(page);
  },

  async 'a dragged link takes its loops along'(browser) {
    for (const [model, flags, link, point, by] of [
      ['models/four_bar.urdf', ['--link', 'coupler', '--point', '0.35,0.1,0', '--normal', '0,1,0'], 'rocker', null, [25, 0]],
      [SHEET, ['--at', 'spring'], 'upright', null, [0, -30]],
      ['models/six_r_arm.urdf', ['--link', 'tool', '--point', '0.08,0,0', '--normal', '0,0,-1'], 'tool', null, [20, 20]],
    ]) {
      const page = await open(browser, explore(model, ...flags));
      await settle(page);
      // A drawn point of the link that the pointer reaches: no other link, mark or button is in front of it.
      const from = await page.evaluate(([name]) => {
        const view = window.percussView;
        const { scene } = view.state();
        const index = scene.links.findIndex((l) => l.name === name);
        for (const [a, b] of scene.links[index].lines) {
          for (const part of [0.5, 0.35, 0.65, 0.2, 0.8]) {
            const at = a.map((x, k) => x + part * (b[k] - x));
            const place = view.onScreen(name, at);
            if (view.linkUnder(place.x, place.y) === index) return { ...place, at };
          }
        }
        return null;
      }, [link]);
      assert.ok(from, `${model}: ${link} is seen`);
      const before = await state(page);
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      for (let k = 1; k <= 12; k++) {
        await page.mouse.move(from.x + (by[0] * k) / 12, from.y + (by[1] * k) / 12);
        await page.waitForTimeout(30);
      }
      await page.waitForTimeout(200);
      await page.mouse.move(from.x + by[0], from.y + by[1] + 0.5);
      await page.waitForTimeout(100);
      await page.mouse.up();
      await settle(page);
      const after = await state(page);
      assert.notDeepEqual(after.values, before.values, `${model}: ${link} has moved`);
      await agrees(page, root, model);
      // The point moves along its path; no neighbouring value of the driver is nearer to the pointer.
      const to = await page.evaluate(([name, at]) => window.percussView.onScreen(name, at), [link, from.at]);
      const moved = [to.x - from.x, to.y - from.y];
      const along = (moved[0] * by[0] + moved[1] * by[1]) / Math.hypot(...by);
      assert.ok(along > 4 || Math.hypot(...moved) > 4, `${model}: the point moves by ${moved.map((x) => x.toFixed(1))} pixels`);
      if (model.endsWith('double-wishbone.toml')) {
        assert.ok(Math.abs(moved[1] - by[1]) < FOLLOWS, `${model}: the point moves by ${moved.map((x) => x.toFixed(1))} instead of ${by}`);
      }
      await page.keyboard.press('Control+z');
      await settle(page);
      assert.deepEqual((await state(page)).values, before.values, 'one gesture is one step of undo');
      await close(page);
    }
  },

  async 'ends of the travel are said in words'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring'));
    await page.fill('[aria-label="wheel travel, mm"]', '0');
    await page.keyboard.press('Tab');
    await rested(page);
    assert.equal(await page.locator('.remarks').count(), 0, 'the range of the stops is reached');
    await close(page);
    // A crank-rocker driven by its rocker: crank 0.3, coupler 0.5, rocker and ground 0.65 m. The rocker turns between the two poses
    // in which crank and coupler are in line, at distances of 0.8 and 0.2 m: cos φ = 1 − d²/(2·0.65²), from cos φ = 0.25/0.65 at zero.
    const path = join(folder, 'rocker.urdf');
    writeFileSync(path, fileText('models/four_bar.urdf').replace(' independent="true"', '')
      .replace('name="rocker_hinge" type="continuous"', 'name="rocker_hinge" type="continuous" independent="true"'));
    const flags = ['--link', 'coupler', '--point', '0.35,0.1,0', '--normal', '0,1,0'];
    const linkage = await open(browser, explore(path, ...flags));
    await rested(linkage);
    const { ends } = await state(linkage);
    const turn = (d) => Math.acos(0.25 / 0.65) - Math.acos(1 - d ** 2 / (2 * 0.65 ** 2));
    assert.equal(ends.length, 2);
    for (const [i, d] of [0.8, 0.2].entries()) {
      const { inside, outside } = ends[i];
      const [low, high] = [inside, outside].sort((x, y) => x - y);
      assert.ok(low <= turn(d) && turn(d) <= high && high - low < 1e-3, `${low} to ${high} for ${turn(d)}`);
    }
    const words = await linkage.textContent('.remarks');
    assert.match(words, /dead centre/);
    assert.ok(words.includes(((turn(0.2) * 180) / Math.PI).toFixed(2)), words);
    // A drag of the rocker ends there, with a result.
    await linkage.focus('[aria-label="rocker_hinge in the curve"]');
    for (let k = 0; k < 12; k++) await linkage.keyboard.press('PageUp');
    await settle(linkage);
    assert.match(await linkage.textContent('.box.bad'), /reach/);
    await close(linkage);
  },

  async 'bands of a target and of tolerances'(browser) {
    const page = await open(browser, explore(SHEET, ...at));
    await rested(page);
    await page.click('text=Target, tolerance');
    await page.check('.bands >> text=target');
    await page.fill('[aria-label="target from, kg"]', '1');
    await page.keyboard.press('Tab');
    await page.fill('[aria-label="target to, kg"]', '2');
    await page.keyboard.press('Tab');
    assert.match(await page.textContent('.remarks'), /Nowhere inside/);
    await page.fill('[aria-label="target to, kg"]', '10000');
    await page.keyboard.press('Tab');
    assert.match(await page.textContent('.remarks'), /Inside of the target from/);
    assert.equal(await page.locator('.figure .target').count(), 1);
    await page.check('.bands >> text=tolerance');
    await rested(page);
    const { variation } = await state(page);
    assert.ok(variation.length >= 5 && await page.locator('.figure .within').count() === 2);
    const { at: travel, rss, worst } = variation[2];
    const { tolerance } = json('mass', SHEET, '--at', 'spring', `--wheel-travel=${travel * 1000}mm`, '--tolerance', 'point=1mm');
    // The travel is rounded to a nanometre in the question.
    for (const [here, there] of [[rss, tolerance.root_sum_square], [worst, tolerance.worst_case]]) {
      assert.ok(Math.abs(here - there) < 1e-4 * there, `${here} here, ${there} by the command`);
    }
    await close(page);
  },

  async 'a map colours the facets, an ellipsoid shows the directions'(browser) {
    const model = 'models/shaped_arm.urdf';
    const page = await open(browser, explore(model));
    await page.click('.menu summary');
    await page.click('.shows >> text=Map');
    await rested(page);
    const [low, high] = (await page.getAttribute('.legend[data-map]', 'data-map')).split(' ').map(Number);
    const map = json('map', model, '--all');
    const extremes = map.links.map((l) => [l.smallest, l.largest]);
    const masses = extremes.flat().map((e) => e?.effective_mass).filter((m) => typeof m === 'number');
    // The page draws the visual shapes, the command takes those of collisions: the ranges overlap, and are not the same.
    assert.ok(low >= Math.min(...masses) * (1 - SAME) && high <= Math.max(...masses) * (1 + SAME) && low < high, `${low} to ${high}: ${masses}`);
    await page.click('.shows >> text=Directions');
    const { principal } = await result(page, 'directions');
    const { study } = await state(page);
    const there = json('map', model, '--link', study.contact.link, '--point', study.contact.point.join(','), '--directions', '1');
    principal.forEach((p, i) => (p.effective_mass === null ? assert.equal(p.status, there.principal[i].status) : same(p.effective_mass, there.principal[i].effective_mass, `axis ${i}`)));
    // The picture follows with the next frame.
    await page.waitForFunction(() => document.querySelectorAll('.directions line').length === 3);
    await page.click('.shows >> text=Map');
    assert.equal(await page.locator('.legend[data-map]').count(), 0);
    await close(page);
  },

  async 'tabs follow the keyboard, keep what is typed and are in the link'(browser) {
    const tabs = (page) => page.$$eval('.answers [role=tab]', (all) => all.map((tab) => tab.textContent));
    const chosen = (page) => page.$$eval('.answers [role=tab]', (all) => all.filter((tab) => tab.ariaSelected === 'true').map((tab) => tab.id.replace('tab-', '')).join());
    const file = explore(SHEET, '--at', 'spring', '--wheel-travel=75mm');
    const page = await open(browser, file);
    await settle(page);
    assert.deepEqual(await tabs(page), ['Result', 'Design', 'Kinematics', 'Impact & damper']);
    await page.focus('#tab-result');
    const seen = [];
    for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowRight', 'ArrowLeft', 'Home', 'End']) {
      await page.keyboard.press(key);
      seen.push(await chosen(page));
      // One panel is visible, that of the tab with the focus; the number and the warnings are beside each.
      assert.deepEqual(await page.$$eval('.answer', (all) => all.filter((panel) => panel.checkVisibility()).map((panel) => panel.getAttribute('aria-labelledby'))), [`tab-${seen.at(-1)}`]);
      assert.equal(await page.evaluate(() => document.activeElement.id), `tab-${seen.at(-1)}`);
      assert.equal(await page.locator('.answers [role=tab][tabindex="0"]').count(), 1);
      assert.ok(await page.isVisible('[data-mass]') && await page.isVisible('.side > section .finding.warning'), seen.at(-1));
    }
    assert.deepEqual(seen, ['design', 'kinematics', 'impact', 'result', 'impact', 'result', 'impact']);
    await page.fill('details.damper input >> nth=0', '0.45');
    await page.keyboard.press('Tab');
    await openTab(page, 'result');
    await page.fill('.target-search input >> nth=0', '100');
    await openTab(page, 'impact');
    assert.equal(await page.inputValue('details.damper input >> nth=0'), '0.45');
    await result(page, 'damper');
    // A result that is not displayed would not follow the design.
    await openTab(page, 'kinematics');
    await result(page, 'kinematics');
    assert.deepEqual(Object.keys((await state(page)).results).filter((kind) => kind !== 'map'), ['kinematics']);
    await openTab(page, 'result');
    assert.equal(await page.inputValue('.target-search input >> nth=0'), '100');
    await openTab(page, 'kinematics');
    await rested(page);
    await page.waitForTimeout(400);
    const linked = await open(browser, file, { viewport: { width: 360, height: 640 }, isMobile: true, hasTouch: true }, await page.evaluate(() => location.hash));
    await settle(linked);
    assert.equal(await chosen(linked), 'kinematics');
    await result(linked, 'kinematics');
    assert.equal(await linked.evaluate(() => document.documentElement.scrollWidth), 360);
    await close(linked);
    // A robot has no kinematics of wheels, and a safe speed.
    await page.setInputFiles('input[type=file]', join(root, 'models/six_r_arm.urdf'));
    await page.waitForFunction(() => document.querySelector('.file')?.textContent === 'six_r_arm.urdf' && window.percussView.isSettled());
    assert.deepEqual([await tabs(page), await chosen(page)], [['Result', 'Design', 'Safe speed', 'Impact & damper'], 'result']);
    await close(page);
  },

  async 'a stop is made 5 kg lighter, and the sheet is saved'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'bump_stop'));
    await settle(page);
    const required = Number(((await shown(page)) - 5).toFixed(2));
    await page.waitForSelector('.tornado tr');
    await page.fill('.target-search input >> nth=0', String(required));
    await page.click('.target-search button');
    await page.waitForFunction(() => /Changed/.test(document.querySelector('.told')?.textContent ?? ''));
    await settle(page);
    await openTab(page, 'design');
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Save the sheet (1 change)')]);
    const saved = join(folder, 'lighter.toml');
    await download.saveAs(saved);
    same(json('mass', saved, '--at', 'bump_stop').effective_mass, await shown(page), 'the saved sheet');
    assert.ok(Math.abs((await shown(page)) - required) < 1e-3);
    await close(page);
  },

  async 'hostile names of links, joints, contacts and files stay text'(browser) {
    const name = `"><img src=x onerror="document.title=1">&amp;'\u202e{{x}}`;
    const escaped = name.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
    const text = fileText('models/planar_2r.urdf').replaceAll('"outer"', `"${escaped}"`).replaceAll('"elbow"', `"joint ${escaped}"`)
      .replace(/<robot name="[^"]*"/, `<robot name="${escaped}"`);
    const path = join(folder, `hostile ' <b> & name.urdf`);
    writeFileSync(path, text);
    const page = await open(browser, explore(path));
    await settle(page);
    for (const kind of ['impact', 'damper']) await openPanel(page, kind);
    await rested(page);
    await page.click('button[title^="Keeps the present"]');
    assert.equal(await page.locator('img').count(), 0);
    assert.ok((await page.textContent('body')).includes(name));
    await agrees(page, folder, 'hostile names');
    await page.click('[role=tab]:has-text("Study")');
    const study = join(folder, 'hostile.toml');
    writeFileSync(study, await page.textContent('pre.text[aria-label=Study]'));
    const report = JSON.parse(execFileSync(process.env.PERCUSS, ['run', study, '--format', 'json'], { cwd: folder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }));
    same(await shown(page), report.effective_mass, 'the study with hostile names');
    await page.click('[role=tab]:has-text("Command")');
    await close(page);
    // A hostile address is refused with words.
    const linked = await open(browser, explore(SHEET), {}, '#1:%3Cscript%3Ealert(1)%3C/script%3E');
    assert.match(await linked.textContent('.notice'), /damaged/);
    await close(linked);
  },
};

function refused(...args) {
  try {
    percuss(...args);
  } catch (error) {
    return error.stderr.toString();
  }
  return assert.fail(`${args.join(' ')} is accepted`);
}
