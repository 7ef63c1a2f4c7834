// Tests of folders with included files, meshes and tables, of the moments of inertia, and of the tables of a study in the panels.

import assert from 'node:assert/strict';
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { agrees, close, explore, fileText, folder, join, json, open, openPanel, openTab, rested, root, settle, shown, state } from './harness.mjs';

const SHEET = 'models/suspensions/double-wishbone.toml';
/** Largest relative difference between WebAssembly and the native command; amplified rounding errors stay far below. */
const SAME = 1e-9;

const TETRAHEDRON = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n';
const SCENE = '<mujoco model="scene"><include file="arm.xml"/></mujoco>';
const ARM = `<mujoco model="arm"><compiler meshdir="assets"/><asset><mesh name="t" file="t.obj"/></asset>
  <worldbody><body name="arm"><joint name="hinge" axis="0 1 0"/><geom type="mesh" mesh="t" density="600"/><site name="tip" pos="1 0 0"/></body></worldbody></mujoco>`;
const URDF = `<robot name="pin"><link name="base"/><joint name="hinge" type="revolute"><parent link="base"/><child link="pin"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <link name="pin"><inertial><origin xyz="0.3 0 0"/><mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.2" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual><geometry><mesh filename="package://parts/meshes/t.obj"/></geometry></visual></link></robot>`;

/** Makes a folder with three models: MJCF in two files with an inertia from a mesh, URDF with a mesh of a package, a sheet with a table. */
function makeFolder(name) {
  const top = join(folder, name);
  rmSync(top, { recursive: true, force: true });
  const write = (path, text) => {
    const file = join(top, path);
    mkdirSync(file.replace(/\/[^/]*$/, ''), { recursive: true });
    writeFileSync(file, text);
  };
  write('mjcf/scene.xml', SCENE);
  write('mjcf/arm.xml', ARM);
  write('mjcf/assets/t.obj', TETRAHEDRON);
  write('robot/urdf/pin.urdf', URDF);
  write('shared/parts/meshes/t.obj', TETRAHEDRON);
  const text = fileText(SHEET);
  const from = text.indexOf('\n[points]') + 1;
  const to = text.indexOf('\n[', from + 1) + 1;
  const rows = [...text.slice(from, to).matchAll(/^(\w+) = \[(.*?)\]/gm)].map(([, point, numbers]) => `${point},${numbers}`);
  write('car/points.csv', `name,x,y,z\n${rows.join('\n')}\n`);
  write('car/car.toml', `points = "points.csv"\n${text.slice(0, from)}${text.slice(to)}`);
  write('notes.xml', '<notes/>');
  write('.git/config.xml', '<robot name="hidden"/>');
  return top;
}

const listed = (page) => page.$$eval('.chooser li b', (all) => all.map((b) => b.textContent));

/** Chooses a model of the list and waits for its result. */
async function choose(page, name) {
  await page.click(`.chooser li button:has(b:text-is("${name}"))`);
  await page.waitForFunction((file) => document.querySelector('.file')?.textContent === file && window.percussView.isSettled(), name);
}

/** Drops a folder or a file of the file system on the page, as a file manager does. */
async function drop(page, path, x = 300, types = ['dragEnter', 'dragOver', 'drop']) {
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files: [path], dragOperationsMask: 1 };
  for (const type of types) await session.send('Input.dispatchDragEvent', { type, x, y: 300, data });
}

export const folderTests = {
  async 'a file is dropped anywhere'(browser) {
    const page = await open(browser, explore(SHEET));
    await settle(page);
    const file = join(root, 'models/four_bar.urdf');
    // Over the tables, where no picture is.
    await drop(page, file, 1300, ['dragEnter', 'dragOver']);
    await page.waitForSelector('.drop');
    await drop(page, file, 1300, ['drop']);
    await page.waitForFunction(() => document.querySelector('.file')?.textContent === 'four_bar.urdf' && window.percussView.isSettled());
    assert.equal(await page.locator('.drop').count(), 0);
    await agrees(page, join(root, 'models'), 'the dropped file');
    await close(page);
  },

  async 'a chosen folder opens with its includes, meshes and tables'(browser) {
    const top = makeFolder('several');
    const page = await open(browser, explore(SHEET));
    await page.setInputFiles('input[aria-label="Folder with a model"]', top);
    await page.waitForSelector('.chooser[open]');
    // An included model is last. Other XML files and files in hidden folders are not listed.
    assert.deepEqual(await listed(page), ['car.toml', 'scene.xml', 'pin.urdf', 'arm.xml']);
    await page.keyboard.press('Escape');
    await page.waitForFunction(() => !document.querySelector('.chooser'));
    for (const name of ['scene.xml', 'pin.urdf', 'car.toml']) {
      await page.setInputFiles('input[aria-label="Folder with a model"]', top);
      await page.waitForSelector('.chooser[open]');
      await choose(page, name);
      await agrees(page, folder, name);
      assert.equal(await page.locator('.notice').count(), 0, name);
      const { scene } = await state(page);
      if (name === 'scene.xml') assert.ok(Math.abs(scene.links.find((l) => l.name === 'arm').mass - 100) < SAME * 100, 'the mass of the mesh');
      // The meshes are drawn, so the surface can be mapped; the sheet has no shapes.
      assert.equal(await page.locator('.shows button:has-text("Map")').count(), name === 'car.toml' ? 0 : 1, name);
    }
    // Points of the table can be moved, and the copied link contains the table.
    const first = await shown(page);
    await openTab(page, 'design');
    await page.fill('[aria-label="lower_ball z, mm"]', '190');
    await page.keyboard.press('Tab');
    await agrees(page, folder, 'a moved point of a table');
    const moved = await shown(page);
    assert.notEqual(moved, first);
    await rested(page);
    const again = await open(browser, explore(SHEET), {}, await page.evaluate(() => location.hash));
    await settle(again);
    assert.equal(await shown(again), moved);
    await close(again);
    await close(page);
  },

  async 'a dropped folder with one model opens at once'(browser) {
    const top = makeFolder('one');
    for (const path of ['mjcf/scene.xml', 'car', 'mjcf']) rmSync(join(top, path), { recursive: true });
    const page = await open(browser, explore(SHEET));
    await drop(page, top);
    await page.waitForFunction(() => document.querySelector('.file')?.textContent === 'pin.urdf' && window.percussView.isSettled());
    await agrees(page, folder, 'dropped');
    assert.equal(await page.locator('.shows button:has-text("Map")').count(), 1, 'the mesh is drawn');
    // The file alone gives the same m̄; the page reports the missing mesh.
    const before = await shown(page);
    await page.setInputFiles('input[type=file]', join(top, 'robot/urdf/pin.urdf'));
    await page.waitForSelector('.notice');
    await settle(page);
    assert.match(await page.textContent('.notice'), /1 link is drawn without its shape.*Folder/);
    assert.equal(await shown(page), before);
    rmSync(join(top, 'robot'), { recursive: true });
    await drop(page, top);
    await page.waitForFunction(() => /is a model/.test(document.querySelector('.notice')?.textContent ?? ''));
    await close(page);
  },

  async 'a written page contains the files of its model'(browser) {
    const top = makeFolder('written');
    for (const path of ['mjcf/scene.xml', 'car/car.toml']) {
      const page = await open(browser, explore(join(top, path)));
      await agrees(page, root, path);
      const [download] = await Promise.all([page.waitForEvent('download'), page.click('text=Save page')]);
      const saved = join(folder, 'saved-files.html');
      await download.saveAs(saved);
      const third = await open(browser, saved);
      await settle(third);
      assert.equal(await shown(third), await shown(page), path);
      await close(third);
      await close(page);
    }
  },

  async 'moments of inertia are changed like masses'(browser) {
    const page = await open(browser, explore(SHEET, '--at', 'spring'));
    await settle(page);
    const first = await shown(page);
    await openTab(page, 'design');
    await page.click('summary:has-text("Masses and moments of inertia")');
    const field = page.locator('input[aria-label^="y moment of inertia of wheel,"]').first();
    const value = Number(await field.inputValue());
    assert.ok(value > 0);
    await field.fill(String(1.1 * value));
    await page.keyboard.press('Tab');
    await agrees(page, root, 'a larger moment');
    const changed = await shown(page);
    const command = await page.textContent('pre.text[aria-label=Command]');
    assert.match(command, /--link-inertia=wheel=/);
    await page.fill('input[aria-label="mass of wheel, kg"]', '10');
    await page.keyboard.press('Tab');
    await agrees(page, root, 'mass and moment');
    // The focus is in the next field, whose text is unchanged, so the page undoes its own last step.
    await page.keyboard.press('Control+z');
    await settle(page);
    assert.equal(await shown(page), changed, 'the mass is undone');
    await rested(page);
    const again = await open(browser, explore(SHEET), {}, await page.evaluate(() => location.hash));
    await settle(again);
    assert.equal(await shown(again), changed, 'the link has the moments');
    await close(again);
    await page.click('[role=tab]:has-text("Study")');
    assert.match(await page.textContent('pre.text[aria-label=Study]'), /link_inertia = \{ wheel = \[/);
    await page.click('[aria-label="mass and inertia of wheel as in the file"]');
    await settle(page);
    assert.equal(await shown(page), first, 'as in the file');
    // Moments that no body has are refused with the reason.
    await field.fill('1e6');
    await page.waitForSelector('.box.bad');
    assert.match(await page.textContent('.box.bad'), /sum of the other two/);
    await page.keyboard.press('Escape');
    await settle(page);
    assert.equal(await shown(page), first);
    await close(page);
  },

  async 'panels begin with the tables of a study'(browser) {
    const MODEL = 'models/six_r_arm.urdf';
    const study = join(folder, 'panels.toml');
    writeFileSync(study, `[model]\npath = "${join(root, MODEL)}"\n[contact]\nlink = "tool"\npoint = [0.08, 0, 0]\nnormal = [0, 0, -1]\n
[damping]\nrestitution = 0.4\nstiffness = "250 N/mm"\nspeed = 0.7\nlaw = "kelvin-voigt"\nseparation = "gap"\nfor = ["drake", "mujoco"]\n
[impact]\nrestitution = 0.1\nspeed = "2 m/s"\nfriction = 0.2\n
[safe_speed]\nregion = "hand"\nforce = 130\nload = 1.5\n`);
    const page = await open(browser, explore(study));
    await rested(page);
    const contact = ['--link', 'tool', '--point', '0.08,0,0', '--normal', '0,0,-1'];
    const results = {};
    // The last two are in one tab.
    for (const kind of ['safe', 'damper', 'impact']) {
      await openPanel(page, kind);
      await rested(page);
      results[kind] = (await state(page)).results[kind];
    }
    const near = (here, there, what) => assert.ok(Math.abs(here - there) <= SAME * Math.abs(there), `${what}: ${here} here, ${there} by the command`);
    const damper = json('damp', '--mass-from', MODEL, ...contact, '--restitution', '0.4', '--stiffness', '250N/mm', '--speed', '0.7', '--separation', 'gap', '--for', 'drake');
    for (const key of ['damping', 'peak_force', 'contact_duration']) near(results.damper.ok[key], damper[key], key);
    assert.deepEqual(Object.keys(results.damper.ok.exports), ['drake']);
    assert.match(await page.textContent('details.damper .command pre'), /--separation=gap/);
    near(results.impact.ok.impulse, json('impact', MODEL, ...contact, '--restitution', '0.1', '--speed', '2m/s').impulse, 'impulse');
    assert.match(await page.textContent('details.impact'), /leaves out: friction\./);
    const safe = json('safe-speed', MODEL, ...contact, '--region', 'hand', '--force', '130', '--load', '1.5');
    near(results.safe.ok[0].reflected.speed, (Array.isArray(safe) ? safe[0] : safe).reflected.speed, 'safe speed');
    await close(page);
  },
};
