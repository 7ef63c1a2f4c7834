// Tests of cables and lines, named contacts, joint stops, keyframes, MJCF and SDFormat, and of the commands of the panels.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { agrees, close, explore, fileText, folder, join, open, openPanel, openTab, percuss, rested, root, settle, shown, state } from './harness.mjs';

const SHEET = 'models/suspensions/double-wishbone.toml';
const ARM = ['models/six_r_arm.urdf', '--link', 'tool', '--point', '0.08,0,0', '--normal', '0,0,-1'];
/** Largest relative difference between WebAssembly and the native command; amplified rounding errors stay far below. */
const SAME = 1e-9;

/** Crane in MJCF with two keyframes, a site and a limited hinge. */
const CRANE = `<mujoco model="crane"><compiler angle="radian"/>
  <worldbody><body name="mast"><joint name="slew" axis="0 0 1"/><inertial pos="0 0 1" mass="40" diaginertia="14 14 1"/>
    <body name="boom" pos="0 0 2"><joint name="luff" axis="0 -1 0" range="-0.2 1.2"/><inertial pos="1.5 0 0" mass="12" diaginertia="0.1 9 9"/>
      <site name="hook" pos="3 0 0"/></body></body></worldbody>
  <keyframe><key name="rest" qpos="0 0"/><key name="raised" qpos="0.4 0.9"/></keyframe></mujoco>`;

/** Runs the command of a panel in a shell and returns its JSON. */
function executed(command, cwd) {
  const text = execFileSync('bash', ['-c', `${command.replace(/^percuss/, '"$PERCUSS"')} --format json 2>/dev/null`], { cwd, encoding: 'utf8' });
  return JSON.parse(text);
}

const commandOf = (page, kind) => page.textContent(`details.${kind} .command pre`);

function same(here, there, what) {
  assert.ok(typeof here === 'number' && Math.abs(here - there) <= SAME * Math.abs(there), `${what}: ${here} here, ${there} by the command`);
}

async function load(page, path) {
  await page.setInputFiles('input[type=file]', path);
  await page.waitForFunction((name) => document.querySelector('.file')?.textContent === name && window.percussView.isSettled(), path.replace(/.*\//, ''));
}

export const contactTests = {
  async 'the first curve is over a joint that moves the contact'(browser) {
    const chosen = async (...point) => {
      const page = await open(browser, explore(ARM[0], '--link', 'tool', '--point', point.join(','), '--normal', '0,0,-1'));
      await settle(page);
      const name = await page.locator('.curve-head select').inputValue();
      await close(page);
      return name;
    };
    // The roll of the tool moves points beside its axis, x of the tool.
    assert.equal(await chosen(0.08, 0.01, 0), 'tool_roll');
    assert.notEqual(await chosen(0.08, 0, 0), 'tool_roll');
  },

  async 'models in MJCF and SDFormat open with sites, keyframes and loops'(browser) {
    const page = await open(browser, explore(SHEET));
    const crane = join(folder, 'crane.xml');
    writeFileSync(crane, CRANE);
    await load(page, crane);
    await agrees(page, folder, 'the site');
    const first = await shown(page);
    const pose = page.locator('label:has(> span:text-is("pose")) select');
    assert.deepEqual(await pose.locator('option').allTextContents(), ['all joints at 0', 'rest', 'raised']);
    await pose.selectOption('raised');
    await settle(page);
    // At 0.9 rad the lever arm of the hook is shorter, so m̄ is larger.
    assert.notEqual(await shown(page), first);
    assert.match(await page.textContent('pre.text[aria-label=Command]'), /--pose=raised/);
    await agrees(page, folder, 'a keyframe');
    // A changed joint starts from the keyframe; the button restores the keyframe.
    const raised = await shown(page);
    await page.fill('[aria-label="luff, °"]', '20');
    await page.keyboard.press('Tab');
    await agrees(page, folder, 'a driver beside the keyframe');
    assert.notEqual(await shown(page), raised);
    await page.click('text=Pose raised');
    await settle(page);
    assert.equal(await shown(page), raised);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal(await shown(page), first);
    for (const model of ['models/slider_crank.urdf', 'models/four_bar.urdf', 'models/six_r_arm.urdf']) {
      const sdf = join(folder, model.replace(/.*\//, '').replace('.urdf', '.sdf'));
      percuss('convert', model, '-o', sdf, '--force');
      await load(page, sdf);
      await agrees(page, folder, sdf);
      // A page written by the command shows the same m̄.
      const written = await open(browser, explore(sdf));
      await settle(written);
      assert.equal(await shown(written), await shown(page));
      await close(written);
    }
    await close(page);
  },

  async 'a page begins at a keyframe of its model'(browser) {
    const crane = join(folder, 'crane.xml');
    writeFileSync(crane, CRANE);
    const page = await open(browser, explore(crane, '--at', 'hook', '--pose', 'raised'));
    await settle(page);
    await agrees(page, root, 'the keyframe of the flags');
    assert.equal((await state(page)).study.pose.file, 'raised');
    await close(page);
  },

  async 'a cable and the line of a spring are contacts'(browser) {
    const page = await open(browser, explore(ARM[0], '--link', 'forearm', '--point', '0.2,0,0', '--along-line', 'pedestal:0.1,0.2,1.4', '--cable'));
    await settle(page);
    await agrees(page, root, 'the cable of the flags');
    assert.match(await page.textContent('pre.text[aria-label=Command]'), /--cable/);
    assert.equal(await page.locator('.contact .rope').count(), 1);
    // The study of the page contains the far end of the cable.
    const { study } = await state(page);
    assert.deepEqual(study.contact.along_line, { link: 'pedestal', point: [0.1, 0.2, 1.4] });
    await page.fill('[aria-label="end of the line z, mm, frame of the link"]', '900');
    await page.keyboard.press('Tab');
    await agrees(page, root, 'its other end');
    const direction = page.locator('label:has(> span:text-is("direction")) select');
    for (const kind of ['turning', 'normal', 'cable', 'line']) {
      await direction.selectOption(kind);
      await agrees(page, root, `direction: ${kind}`);
    }
    // The line of a cable may turn by any angle.
    await direction.selectOption('cable');
    await page.fill('[aria-label="shoulder, °"]', '-40');
    await page.keyboard.press('Tab');
    await agrees(page, root, 'a cable that has turned');
    await close(page);
  },

  async 'contacts that a sheet names itself are in the list'(browser) {
    const sheet = join(folder, 'skid.toml');
    writeFileSync(sheet, `${fileText(SHEET)}\n[contact.skid]\npoint = [100.0, 400.0, 80.0]\non = "lower_arm"\ndirection = [0.0, 0.0, -1.0]\n`);
    const page = await open(browser, explore(sheet));
    await settle(page);
    await page.click('[data-contact-name=skid]');
    await agrees(page, folder, 'the contact of the sheet');
    assert.match(await page.textContent('.result'), /skid/);
    // The contact remains after a hardpoint has moved.
    await openTab(page, 'design');
    await page.fill('[aria-label="lower_ball z, mm"]', String(Number(await page.inputValue('[aria-label="lower_ball z, mm"]')) + 4));
    await page.keyboard.press('Tab');
    await agrees(page, folder, 'the same with a moved hardpoint');
    await close(page);
  },

  async 'the stop of a joint has the inertia of its command'(browser) {
    const page = await open(browser, explore(...ARM, '--set', 'shoulder=-40deg'));
    await settle(page);
    await openPanel(page, 'damper');
    await page.locator('details.damper label:has(> span:text-is("contact")) select').selectOption('elbow:upper');
    await rested(page);
    const found = (await state(page)).results.damper.ok;
    assert.equal(found.stop.motion, 'turn');
    const there = executed(await commandOf(page, 'damper'), root);
    for (const key of ['effective_mass', 'damping', 'peak_force']) same(found[key], there[key], key);
    assert.match(await page.textContent('details.damper'), /kg·m²/);
    await page.locator('details.damper label:has(> span:text-is("contact")) select').selectOption('');
    await rested(page);
    const contact = (await state(page)).results.damper.ok;
    same(contact.effective_mass, await shown(page), 'the contact again');
    await close(page);
  },

  async 'the commands of the panels print their numbers'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring', '--wheel-travel=20mm'));
    await openTab(page, 'design');
    await page.fill('[aria-label="upper_ball y, mm"]', String(Number(await page.inputValue('[aria-label="upper_ball y, mm"]')) - 5));
    await page.keyboard.press('Tab');
    const both = async (kind) => {
      await openPanel(page, kind);
      await rested(page);
      return [(await state(page)).results[kind].ok, executed(await commandOf(page, kind), root)];
    };
    const [damper, itsCommand] = await both('damper');
    same(damper.damping, itsCommand.damping, 'damping');
    const [impact, command] = await both('impact');
    same(impact.impulse, command.impulse, 'impulse');
    const [here, there] = await both('kinematics');
    for (const key of ['camber', 'toe', 'caster']) assert.ok(Math.abs(here.rows[0][key] - there.rows[0][key]) < SAME, key);
    await close(page);
    const arm = await open(browser, explore(...ARM));
    await openPanel(arm, 'safe');
    await rested(arm);
    await arm.fill('details.safe input >> nth=0', '140 N');
    await arm.keyboard.press('Tab');
    await rested(arm);
    const speeds = executed(await commandOf(arm, 'safe'), root);
    same((await state(arm)).results.safe.ok[0].reflected.speed, (Array.isArray(speeds) ? speeds[0] : speeds).reflected.speed, 'safe speed');
    await close(arm);
  },
};
