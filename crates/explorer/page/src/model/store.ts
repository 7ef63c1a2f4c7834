// State of the page. The study is the question; every gesture that changes it is one entry of the history.

import { Ended, Engine } from '../engine/engine';
import type {
  ContactListReport, ContactTable, Curve, CurveRow, Explanation, DiagnosticRecord, Found, ListedContact, Opened, Outcome, PosedMass, Refusal, Scene, Shown, Study, Triple,
} from '../engine/protocol';
import { Answers } from './answers';
import { filesOfModel, modelsOf, type FoundModel, type ModelFiles, type NamedFile } from './files';
import { drivers, firstDriver, valueOf, parts, vary, withValue, type Driver } from './drivers';
import { endsOf, type End } from './ends';
import { fromHash, toHash, type Start, type ViewName } from './link';
import { MOST_VARIANTS, designKey, nextColour, nextName, type Variant } from './variants';

interface Entry { study: Study; label: string }
/** Rows of the curve; a drag has fewer. */
export const ROWS = 81;
const ROWS_OF_DRAG = 33;
/** Rows and steps of the search for the end of a travel: each step divides the distance between two rows by 20. */
const ROWS_OF_END = 21;
const STEPS_OF_END = 2;
/** Poses of the band of tolerances, each with all sensitivities. */
const POSES_OF_BAND = 9;
/** Delay from the last change to the computations that are omitted during a drag, ms. */
const REST = 250;
/** Time between two curves, and between two results at the named contacts, during a drag, ms. */
const BESIDE = 300;
/** Duration after which a computation is reported, ms. */
const SLOW = 300;
const LONGEST_HISTORY = 200;
const MOST_TIMES = 400;

/** Rows of a curve. */
const rowsOf = (curve: Outcome<Curve>): CurveRow[] | undefined => ('ok' in curve ? curve.ok.rows : undefined);

export class Store {
  engine: Engine | undefined;
  failure: string | undefined;
  notice: string | undefined;
  busy = false;
  fileName = '';
  text = '';
  /** Further files of the model, base64 by path. */
  files: Record<string, string> | undefined;
  /** Folder with several models, from which the user chooses one. */
  folder: { models: FoundModel[]; files: NamedFile[] } | undefined;
  shapes: (string | null)[] | undefined;
  opened: Opened | undefined;
  refusal: Refusal | undefined;
  scene: Scene | undefined;
  study: Study | undefined;
  /** Study of the result shown. */
  answered: Study | undefined;
  posed: PosedMass | undefined;
  /** Reason why the study has no result; `posed` is then the last good one. */
  problem: Refusal | undefined;
  frames: number[] | undefined;
  curve: Outcome<Curve> | undefined;
  explanation: Explanation | null | undefined;
  /** Study of the sensitivities. */
  explained: Study | undefined;
  /** Results at the named contacts for the present design: stops at their touches, others at the set joints. */
  contacts: ListedContact[] = [];
  /** Key of the design of `contacts`. */
  private listed = '';
  private listedAt = 0;
  private curvedAt = 0;
  drivers: Driver[] = [];
  driver: Driver | undefined;
  variants: Variant[] = [];
  view: ViewName = '3d';
  colours: 'share' | 'plain' = 'share';
  showsPoints = true;
  showsNames = true;
  hidesHints = false;
  showsMotion = false;
  showsDesign = false;
  selected: string | undefined;
  /** True while the next click on a link makes a contact there. */
  choosing = false;
  /** Moves of the hardpoints when the model was opened; the coordinates of the opened scene include them. */
  movedAtOpening: Record<string, Triple> = {};
  past: Entry[] = [];
  future: Entry[] = [];
  /** Target range of m̄, kg. */
  target: [number, number] | undefined;
  /** Tolerance of each coordinate of the hardpoints, m. */
  tolerance: number | undefined;
  /** Variation of m̄ within the tolerance along the curve, kg: root of the sum of squares, and sum. */
  variation: { at: number; mass: number; rss: number; worst: number }[] | undefined;
  /** Ends of the displayed branch, refined after a drag. */
  ends: End[] = [];
  private resting: Promise<void> = Promise.resolve();
  readonly answers = new Answers(
    (request) => this.ask(request), () => ({ study: this.problem ? undefined : this.study, state: this.state() }), () => this.changed(),
  );
  private gesture: Entry | undefined;
  private dirty = false;
  private working = false;
  private rest: ReturnType<typeof setTimeout> | undefined;
  /** Times from question to reply, ms. */
  readonly times: number[] = [];
  private listeners = new Set<() => void>();

  listen(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  changed() {
    for (const listener of this.listeners) listener();
  }

  set(values: Partial<Store>) {
    Object.assign(this, values);
    this.changed();
  }

  // ---- opening -------------------------------------------------------------------------------------------------------

  async start(start: Start) {
    try {
      this.engine = await Engine.start();
    } catch (error) {
      this.set({ failure: `This browser does not run the engine (WebAssembly): ${String(error)}` });
      return;
    }
    let linked = null;
    try {
      linked = await fromHash(location.hash);
    } catch (error) {
      this.notice = (error as Error).message;
    }
    const text = linked?.text ?? (linked?.study.model.path === start.model?.name ? start.model?.text : undefined);
    if (linked && text === undefined) this.notice = `The link belongs to a page with ${linked.study.model.path}.`;
    if (linked && text !== undefined) {
      const own = text === start.model?.text ? start.model : undefined;
      const { files = own?.files, driver, study } = linked;
      await this.open({ name: study.model.path, text, files, shapes: own?.shapes }, study, driver);
      if (own) this.answers.begin(start.study?.panels);
      Object.assign(this, { view: linked.view ?? this.view, hidesHints: linked.hidesHints ?? false });
      this.answers.turnTo(linked.tab);
    } else if (start.model) {
      await this.open(start.model, start.study, start.driver);
      this.answers.begin(start.study?.panels);
      if (start.view) this.view = start.view;
      await this.freezeAll(start.variants ?? []);
    }
    this.changed();
  }

  /** Freezes the variants of a study and returns to its own design. */
  private async freezeAll(variants: NonNullable<Start['variants']>) {
    const own = this.study;
    if (!own) return;
    for (const { name, ...values } of variants.slice(0, MOST_VARIANTS)) {
      this.study = { ...own, ...values, model: { ...own.model, ...values.model, path: own.model.path } } as Study;
      await this.update();
      this.freeze(name);
    }
    this.study = own;
    await this.update();
  }

  /** Opens a model of a folder, or shows the list of its models. */
  async openFolder(files: NamedFile[]) {
    this.set({ notice: undefined, folder: undefined });
    const models = await modelsOf(files);
    if (!models.length) {
      this.set({ notice: `None of the ${files.length} files of the folder is a model: expected URDF, MJCF, SDFormat or a suspension sheet.` });
    } else if (models.length === 1) {
      await this.openFromFolder(models[0], files);
    } else {
      this.set({ folder: { models, files } });
    }
  }

  async openFromFolder(chosen: FoundModel, files: NamedFile[]) {
    this.set({ folder: undefined });
    const { model, left } = await filesOfModel(chosen, files);
    await this.open(model);
    if (left.length) this.set({ notice: `${left.length === 1 ? '1 file is' : `${left.length} files are`} left out (the page reads at most 64 MiB): ${left.slice(0, 3).join(', ')}${left.length > 3 ? ' …' : ''}` });
  }

  async open({ name, text, files, shapes }: ModelFiles, given?: Partial<Study>, driver?: string) {
    const model = { ...given?.model, path: name };
    const reply = await this.ask<Opened>({ do: 'open', model, text, files, shapes: !shapes });
    if (!reply) return;
    if ('refused' in reply) {
      this.set({ refusal: reply.refused, ...(this.opened ? {} : { fileName: name, text, files }) });
      return;
    }
    const opened = reply.ok;
    const hasContact = given?.contact && Object.values(given.contact).some((value) => value !== false);
    const study: Study = {
      model,
      contact: hasContact ? given.contact! : opened.contact,
      pose: given?.pose ?? {},
      conditions: given?.conditions && Object.keys(given.conditions).length > 0 ? given.conditions : opened.conditions,
      ...(given?.hold?.length ? { hold: given.hold } : {}),
    };
    const contacts = opened.contacts?.contacts ?? [];
    const all = drivers(opened.scene, contacts);
    const link = study.contact.link ?? opened.scene.links[opened.scene.contacts.find((c) => c.name === study.contact.at)?.link ?? -1]?.name;
    Object.assign(this, {
      fileName: name, text, files, shapes: shapes ?? opened.shapes?.links, opened, refusal: undefined, scene: opened.scene, study, posed: undefined, problem: undefined,
      frames: opened.scene.design, contacts, listed: '', curve: undefined, explanation: undefined, explained: undefined, drivers: all,
      driver: all.find((d) => d.name === driver) ?? firstDriver(opened.scene, all, link, study.contact.point),
      view: opened.scene.sheet ? 'front' : '3d', choosing: false, variants: [], ends: [], variation: undefined, past: [], future: [], selected: undefined, movedAtOpening: model.move ?? {},
    });
    this.answers.clear();
    const without = opened.shapes?.diagnostics.length;
    if (without) {
      this.notice = `${without} ${without === 1 ? 'link is' : 'links are'} drawn without ${without === 1 ? 'its shape' : 'their shapes'} (see Findings). Meshes are found in a folder with the model: choose it by Folder…, or drop it.`;
    }
    await this.update();
  }

  private async ask<T>(request: Parameters<Engine['ask']>[0]): Promise<Outcome<T> | undefined> {
    const slow = setTimeout(() => this.set({ busy: true }), SLOW);
    try {
      return await this.engine!.ask<T>(request);
    } catch (error) {
      if (!(error instanceof Ended)) {
        // A trap leaves the module in an unknown state.
        this.notice = `The engine stopped: ${(error as Error).message}. The page goes on with a new one.`;
        await this.engine!.end();
        await this.reopen();
      }
      return undefined;
    } finally {
      clearTimeout(slow);
      this.busy = false;
    }
  }

  /** Opens the model in a restarted engine. */
  private reopen() {
    return this.engine!.ask({ do: 'open', model: { path: this.fileName }, text: this.text, files: this.files });
  }

  /** Cancels the current computation; the last result remains. */
  async end() {
    if (!this.busy || !this.engine || !this.study) return;
    await this.engine.end();
    await this.reopen();
    this.set({ busy: false, notice: 'The work was ended. The last result is shown.' });
  }

  // ---- results -------------------------------------------------------------------------------------------------------

  /** Requests the result of the newest study; earlier studies without a result are skipped. */
  async update() {
    this.dirty = true;
    if (this.working) return;
    this.working = true;
    while (this.dirty && this.study) {
      this.dirty = false;
      const study = this.study;
      const asked = performance.now();
      const reply = await this.ask<Shown>({ do: 'show', question: study });
      if (!reply) break;
      this.times.push(performance.now() - asked);
      if (this.times.length > MOST_TIMES) this.times.shift();
      if ('refused' in reply) {
        this.problem = reply.refused;
      } else {
        const { scene, result, frames } = reply.ok;
        if (scene) this.scene = scene;
        if ('ok' in result) {
          this.posed = result.ok;
          this.frames = result.ok.frames;
          this.problem = undefined;
          this.answered = study;
        } else {
          this.problem = result.refused;
          this.frames = frames ?? this.frames;
        }
      }
      this.changed();
      // The picture of a drag first; the curve follows, in a fast drag now and then.
      if ((!this.gesture || !this.dirty || performance.now() - this.curvedAt > BESIDE) && !await this.drawCurve(study)) break;
      // Without delay for a newer change; in a drag, now and then.
      if (!this.dirty && (!this.gesture || performance.now() - this.listedAt > BESIDE)) await this.listContacts(study);
      if (!this.dirty && !this.gesture && this.fitRange()) this.dirty = true;
    }
    this.working = false;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.rest = undefined;
      this.resting = this.atRest();
    }, REST);
    this.changed();
  }

  /** Requests the curve of a study; false after a stop of the engine. */
  private async drawCurve(study: Study): Promise<boolean> {
    const { driver } = this;
    let curve: Outcome<Curve> | undefined;
    for (const { text, downwards } of driver ? parts(driver, this.gesture ? ROWS_OF_DRAG : ROWS, !!this.scene?.closures.length) : []) {
      const part = await this.ask<Curve>({ do: 'curve', question: study, vary: text });
      if (!part) return false;
      if (downwards) rowsOf(part)?.reverse();
      if (curve) rowsOf(curve)?.unshift(...(rowsOf(part) ?? []));
      else curve = part;
    }
    this.curvedAt = performance.now();
    this.curve = curve;
    this.ends = this.rows ? endsOf(this.rows, driver ? this.positionOf(driver) : 0) : [];
    this.variation = undefined;
    this.changed();
    return true;
  }

  /** Starts the computations that are omitted during a drag. */
  private async atRest() {
    if (!this.study || this.working) return;
    if (this.gesture) return this.listContacts(this.study);
    await this.writeHash();
    await this.refineEnds();
    await this.answers.refresh();
    await this.varyPoints();
    await this.explain();
  }

  /** Resolves when all computations for the displayed study are finished. */
  async rested() {
    const isDone = () => this.isIdle && this.rest === undefined && (this.problem !== undefined || this.answers.isFresh());
    while (!isDone()) await new Promise((done) => setTimeout(done, 20));
    await this.resting;
  }

  private get rows() {
    return this.curve && rowsOf(this.curve);
  }

  private async refineEnds() {
    const { study, driver } = this;
    const now = driver && this.positionOf(driver);
    for (const end of this.ends) {
      for (let step = 0; step < STEPS_OF_END; step++) {
        const low = Math.min(end.inside, end.outside);
        const high = Math.max(end.inside, end.outside);
        // The rows begin at the reachable side.
        const downwards = end.side === 'lower';
        const reply = await this.ask<Curve>({ do: 'curve', question: study!, vary: vary({ ...driver!, range: [low, high] }, ROWS_OF_END, downwards) });
        if (this.study !== study || this.driver !== driver || !reply || !('ok' in reply)) return;
        const refined = reply.ok.rows;
        const [found] = endsOf(downwards ? refined.reverse() : refined, end.inside);
        if (!found || now === undefined) break;
        Object.assign(end, { inside: found.inside, outside: found.outside });
      }
    }
    if (this.ends.length) this.set({ ends: [...this.ends] });
  }

  /** Variation of m̄ within the tolerance, to first order, at some poses of the curve. */
  private async varyPoints() {
    const { study, driver, tolerance, rows } = this;
    if (!tolerance || !driver || !rows || !this.scene?.sheet) return;
    const finite = rows.filter((row) => row.mass !== null);
    const count = Math.min(POSES_OF_BAND, finite.length);
    const found: NonNullable<Store['variation']> = [];
    for (let i = 0; i < count; i++) {
      const row = finite[Math.round((i * (finite.length - 1)) / Math.max(1, count - 1))];
      const reply = await this.ask<Explanation | null>({ do: 'explain', question: withValue(study!, driver, row.at) });
      if (this.study !== study || this.tolerance !== tolerance || this.driver !== driver) return;
      if (!reply || !('ok' in reply) || !reply.ok) continue;
      const rates = reply.ok.points.flatMap((point) => point.per_metre ?? []).map((rate) => Math.abs(rate) * tolerance);
      found.push({ at: row.at, mass: row.mass!, rss: Math.hypot(...rates), worst: rates.reduce((a, b) => a + b, 0) });
    }
    this.set({ variation: found });
  }

  setTolerance(tolerance: number | undefined) {
    this.set({ tolerance, variation: undefined });
    this.resting = this.resting.then(() => this.varyPoints());
  }

  /** Value of a driver at the displayed pose, SI. */
  positionOf(driver: Driver): number {
    return this.study ? valueOf(driver, this.study, this.posed) : 0;
  }

  /** Values of the motions of the wheels and of the rack, m. */
  state(): Record<string, number> {
    const named = this.drivers.filter((driver) => driver.isMotion || driver.name === 'rack');
    return Object.fromEntries(named.map((driver) => [driver.isMotion ? driver.name : 'steer', this.positionOf(driver)]).filter(([, value]) => value !== 0));
  }

  /** Frames at another value of a driver; undefined without such a pose. */
  async framesAt(driver: Driver, value: number): Promise<number[] | undefined> {
    const reply = await this.ask<Shown>({ do: 'show', question: withValue(this.study!, driver, value) });
    if (!reply || !('ok' in reply)) return undefined;
    return 'ok' in reply.ok.result ? reply.ok.result.ok.frames : (reply.ok.frames ?? undefined);
  }

  private async writeHash() {
    if (!this.study || this.gesture) return;
    const hash = await toHash(this.linked());
    history.replaceState(null, '', hash);
  }

  linked() {
    return { study: this.study!, text: this.text, files: this.files, driver: this.driver?.name, view: this.view, tab: this.answers.tab, hidesHints: this.hidesHints };
  }

  /** Sensitivities to all hardpoints and masses: the time of some results. */
  private async explain() {
    const { study } = this;
    if (this.problem || this.explained === study) return;
    const reply: Outcome<Explanation | null> | undefined = await this.ask({ do: 'explain', question: study! });
    if (this.study !== study || this.gesture || !reply || !('ok' in reply)) return;
    this.set({ explanation: reply.ok, explained: study });
  }

  /** True if the results at the named contacts belong to the displayed design. */
  get contactsAreFresh(): boolean {
    return !!this.study && this.listed === designKey(this.study);
  }

  private async listContacts(study: Study) {
    if (!this.scene?.contacts.length || this.problem || this.contactsAreFresh) return;
    this.listedAt = performance.now();
    const reply = await this.ask<ContactListReport>({ do: 'contacts', question: { ...study, contact: {}, pose: { ...study.pose, travel: [] } } });
    if (reply && 'ok' in reply) this.set({ contacts: reply.ok.contacts, listed: designKey(study) } as Partial<Store>);
  }

  /** Adapts the ranges of the drivers to the touches of the stops and to the travel shown; true if one has changed. */
  private fitRange(): boolean {
    const all = drivers(this.scene!, this.contacts, this.drivers[0]?.isMotion && !this.problem ? this.positionOf(this.drivers[0]) : 0);
    if (JSON.stringify(all) === JSON.stringify(this.drivers)) return false;
    this.drivers = all;
    const former = this.driver;
    this.driver = all.find((driver) => driver.name === former?.name);
    return JSON.stringify(former) !== JSON.stringify(this.driver);
  }

  /** Changes a coordinate of a hardpoint or the mass of a link so that m̄ has a value, kg, within a distance, m. Returns the search, or the reason of its refusal. */
  async solve(unknown: string, mass: number, within: number): Promise<Found | string> {
    const { study } = this;
    const reply = await this.ask<Found>({ do: 'solve', question: study!, unknown, mass, within });
    if (!reply || this.study !== study) return 'The search was ended.';
    if ('refused' in reply) return reply.refused.message;
    const { is_reached, moves: [moved], link_masses: [link] } = reply.ok;
    const label = `${unknown} for ${mass} kg`;
    if (is_reached && moved) this.movePoint(moved[0], this.moved(moved[0]).map((x, k) => x + moved[1][k]) as Triple, label);
    if (is_reached && link) this.change({ ...study!, model: { ...study!.model, link_mass: { ...study!.model.link_mass, [link[0]]: link[1] } } }, label);
    return reply.ok;
  }

  async sheetText(): Promise<string | undefined> {
    const reply = await this.ask<string>({ do: 'sheet', model: this.study!.model });
    if (reply && 'ok' in reply) return reply.ok;
    if (reply) this.set({ notice: reply.refused.message });
    return undefined;
  }

  // ---- changes -------------------------------------------------------------------------------------------------------

  /** Begins a gesture: all changes until its end are one entry of the history. */
  begin(label: string) {
    this.gesture ??= { study: this.study!, label };
  }

  /** Ends a gesture; with `keep` false, its changes are reverted. */
  finish(keep = true, label?: string) {
    const gesture = this.gesture;
    this.gesture = undefined;
    if (!gesture) return;
    if (!keep) {
      this.study = gesture.study;
    } else if (gesture.study !== this.study) {
      this.past = [...this.past, { study: gesture.study, label: label ?? gesture.label }].slice(-LONGEST_HISTORY);
      this.future = [];
    }
    void this.update();
    this.changed();
  }

  get isIdle(): boolean {
    return this.opened !== undefined && !this.working && !this.gesture;
  }

  /** Ends a gesture after the result of its last change; a refused change is reverted. */
  async finishAnswered(keep: boolean, label: string | undefined) {
    while (this.working) await new Promise((done) => setTimeout(done, 4));
    this.finish(keep && !this.problem, label);
  }

  /** Name of the change that an undo reverts. */
  get lastLabel(): string | undefined {
    return this.gesture?.label ?? this.past.at(-1)?.label;
  }

  get inGesture(): boolean {
    return this.gesture !== undefined;
  }

  change(study: Study, label: string) {
    const alone = !this.gesture;
    if (alone) this.begin(label);
    this.study = study;
    if (!alone) {
      // The page is rendered with the reply in the next frame; rendering now would double the work for each move.
      void this.update();
      return;
    }
    this.finish();
    this.changed();
  }

  undo() {
    const entry = this.past.at(-1);
    if (!entry || this.gesture) return;
    this.past = this.past.slice(0, -1);
    this.future = [...this.future, { study: this.study!, label: entry.label }];
    this.study = entry.study;
    void this.update();
    this.changed();
  }

  redo() {
    const entry = this.future.at(-1);
    if (!entry || this.gesture) return;
    this.future = this.future.slice(0, -1);
    this.past = [...this.past, { study: this.study!, label: entry.label }];
    this.study = entry.study;
    void this.update();
    this.changed();
  }

  chooseDriver(name: string) {
    this.driver = this.drivers.find((driver) => driver.name === name) ?? this.driver;
    this.variants = this.variants.map((v) => (v.driver === name ? v : { ...v, curve: null, driver: name }));
    void this.update();
    this.changed();
  }

  freeze(given?: string) {
    if (!this.posed || !this.study || !this.scene || this.problem) return;
    const name = given ?? nextName(this.variants);
    const curve = this.curve && 'ok' in this.curve ? this.curve.ok : null;
    const others = this.variants.filter((v) => v.name !== name);
    const variant: Variant = {
      name, colour: nextColour(others), study: this.study, mass: this.posed.report.effective_mass, curve, driver: this.driver?.name ?? '',
      scene: this.scene, frames: this.posed.frames,
    };
    const kinematics = this.answers.results.kinematics;
    if (kinematics && 'ok' in kinematics && this.answers.isFresh()) variant.kinematics = kinematics.ok;
    this.set({ variants: [...others, variant] });
  }

  // ---- hardpoints ----------------------------------------------------------------------------------------------------

  /** Displacement of a hardpoint, m, axes of the sheet. */
  moved(name: string): Triple {
    return this.study?.model.move?.[name] ?? [0, 0, 0];
  }

  movePoint(name: string, by: Triple, label: string) {
    const study = this.study!;
    const move = { ...study.model.move };
    // Rounded to 0.1 µm, so that the command contains no digits of rounding.
    const rounded = by.map((x) => Math.round(x * 1e7) / 1e7 + 0) as Triple;
    if (rounded.every((x) => x === 0)) delete move[name];
    else move[name] = rounded;
    const model = { ...study.model, move };
    if (Object.keys(move).length === 0) delete (model as { move?: unknown }).move;
    this.change({ ...study, model }, label);
  }

  setContact(contact: ContactTable, label: string) {
    this.change({ ...this.study!, contact }, label);
  }

  /** Contact of the result as link, point and normal, to be changed freely. */
  ownContact(): ContactTable | undefined {
    const contact = this.study?.contact;
    if (contact && !contact.at && !contact.along_line && !contact.frame) return contact;
    const found = this.posed?.report.contact;
    if (!found) return undefined;
    const round = (values: Triple, scale: number) => values.map((x) => Math.round(x * scale) / scale + 0) as Triple;
    return {
      link: found.link, point: round(found.point_link, 1e5), normal: round(found.normal_link, 1e6),
      ...(found.against ? { against: found.against } : {}),
    };
  }

  /** Factors from the axes of the world to those of the sheet, in which the page shows coordinates and directions. */
  get axes(): Triple {
    return this.scene?.sheet?.hardpoints[0]?.to_world ?? [1, 1, 1];
  }

  get findings(): DiagnosticRecord[] {
    const shapes = this.opened?.shapes?.diagnostics ?? [];
    return [...(this.posed?.report.diagnostics ?? this.opened?.diagnostics ?? []), ...shapes];
  }
}

export const store = new Store();
