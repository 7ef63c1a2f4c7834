// Further results at the pose: damper, impact, safe speed, kinematics, principal directions, maps of surfaces. A result is requested
// only while it is displayed and no drag is in progress.

import type { DampingReport, PointMapReport, GivenContact, ImpactReport, ImpactTimeRecord, KinematicsReport, Outcome, Request, SafeSpeedReport, Study } from '../engine/protocol';

/** Settings of the further results, as texts of a study. */
export interface Settings {
  restitution: string; stiffness: string; speed: string; law: string; tool: string;
  /** Stop of a joint in place of the contact, as JOINT:lower or JOINT:upper; empty for the contact shown. */
  stop: string;
  impactRestitution: string; impactSpeed: string; impactStiffness: string;
  /** `yes`: with the course of the forces over time. */
  impactInTime: string;
  region: string; limit: string; limitValue: string; area: string; load: string;
  /** Keys of the table `damping` of a study that have no field in the panel, with their values. They are sent with the request. */
  further: Record<string, Scalar>;
}

type Scalar = number | string | boolean;

/** Tables of a study with the initial values of the panels. */
export interface PanelTables { damping?: Table | null; impact?: Table | null; safe_speed?: Table | null }
type Table = Record<string, unknown>;

/** Names of the settings that are texts. */
export type TextSetting = Exclude<keyof Settings, 'further'>;

export const DEFAULTS: Settings = {
  restitution: '0.3', stiffness: '200 N/mm', speed: '1 m/s', law: 'kelvin-voigt', tool: 'mujoco', stop: '',
  impactRestitution: '0.3', impactSpeed: '1 m/s', impactStiffness: '', impactInTime: '',
  region: 'chest', limit: 'force', limitValue: '', area: '1 cm2', load: '0', further: {},
};

export type Kind = 'damper' | 'impact' | 'safe' | 'kinematics' | 'directions' | 'map';

/** Tabs of the page, and the results of each. */
export const TABS = { result: [], design: [], kinematics: ['kinematics'], safe: ['safe'], impact: ['impact', 'damper'] } satisfies Record<string, Kind[]>;
export type Tab = keyof typeof TABS;

export interface Results {
  damper: DampingReport;
  impact: ImpactReport;
  safe: SafeSpeedReport[];
  kinematics: KinematicsReport;
  directions: PointMapReport;
  /** By link: m̄ of each facet. */
  map: Map<number, GivenContact[]>;
}

export interface Facets { link: number; name: string; contacts: number[][] }

type Ask = <T>(request: Request) => Promise<Outcome<T> | undefined>;

/** Facets in one request: a reply within a tenth of a second. */
const FACETS_AT_ONCE = 10_000;

export class Answers {
  settings: Settings = { ...DEFAULTS };
  /** Keys of the tables of a study that the panels ignore. */
  leftOut: { [K in Kind]?: string[] } = {};
  results: { [K in Kind]?: Outcome<Results[K]> } = {};
  /** Results that the view shows. */
  private shown = new Set<Kind>();
  tab: Tab = 'result';
  /** Panels that the user has closed. */
  private closed = new Set<Kind>();
  /** Study of the results. */
  private study: Study | undefined;
  private run = 0;
  /** Surfaces of the links with shapes; given by the view. */
  facets: Facets[] = [];
  /** Sample of the impact in time that the user has chosen. */
  moment: number | undefined;

  constructor(
    private readonly ask: Ask, private readonly present: () => { study?: Study; state: Record<string, number> }, private readonly changed: () => void,
  ) {}

  isShown(kind: Kind): boolean {
    return this.wanted().includes(kind);
  }

  private wanted(): Kind[] {
    return [...this.shown, ...TABS[this.tab].filter((kind) => !this.closed.has(kind))];
  }

  /** Turns to a tab; the name can come from a link. */
  turnTo(tab: string | undefined) {
    if (!tab || tab === this.tab || !Object.hasOwn(TABS, tab)) return;
    this.tab = tab as Tab;
    this.forget();
  }

  /** Opens or closes the panel of a result. */
  fold(kind: Kind, open: boolean) {
    if (open !== this.closed.has(kind)) return;
    if (open) this.closed.delete(kind);
    else this.closed.add(kind);
    this.forget();
  }

  isOpen(kind: Kind): boolean {
    return !this.closed.has(kind);
  }

  /** Deletes the results that are no longer displayed: they would not follow the study. */
  private forget() {
    const kinds = this.wanted();
    this.results = Object.fromEntries(Object.entries(this.results).filter(([kind]) => kinds.includes(kind as Kind)));
    this.study = undefined;
    this.changed();
    void this.refresh();
  }

  show(kind: Kind, on: boolean) {
    if (on === this.shown.has(kind)) return;
    if (on) this.shown.add(kind);
    else this.shown.delete(kind);
    this.study = undefined;
    this.changed();
    void this.refresh();
  }

  set(values: Partial<Settings>) {
    Object.assign(this.settings, values);
    this.study = undefined;
    this.changed();
    void this.refresh();
  }

  /** Displayed sample of an impact in time; initially that of the largest force of the contact. */
  momentOf({ force }: ImpactTimeRecord): number {
    return Math.min(this.moment ?? force.indexOf(Math.max(...force)), force.length - 1);
  }

  /** True if the results belong to the displayed study. */
  isFresh(): boolean {
    return this.wanted().length === 0 || this.study === this.present().study;
  }

  clear() {
    this.results = {};
    this.moment = undefined;
    this.tab = 'result';
    Object.assign(this.settings, { stop: '', further: {} });
    this.leftOut = {};
    this.study = undefined;
  }

  /** Sets the fields to the values of a study. */
  begin({ damping, impact, safe_speed }: PanelTables = {}) {
    const texts: Partial<Settings> = {};
    if (damping) {
      const { restitution, stiffness, speed, law, limit, for: tools, output, ...more } = damping;
      void output;
      const further = Object.entries(more).filter((entry): entry is [string, Scalar] => typeof entry[1] !== 'object');
      Object.assign(texts, {
        ...given({ restitution, law, stiffness: limit || more.exponent ? stiffness : withUnit(stiffness, 'N/m') }), speed: text(limit ? speed : withUnit(speed, 'm/s')), stop: text(limit), tool: [tools].flat().map(text).find((tool) => tool && tool !== 'all') ?? DEFAULTS.tool,
        further: Object.fromEntries(further),
      });
      this.leftOut.damper = Object.keys(more).filter((key) => typeof more[key] === 'object');
    }
    if (impact) {
      const { restitution, speed, stiffness, in_time, ...more } = impact;
      Object.assign(texts, given({
        impactRestitution: restitution, impactSpeed: withUnit(speed, 'm/s'), impactStiffness: more.exponent ? stiffness : withUnit(stiffness, 'N/m'), impactInTime: in_time ? 'yes' : '',
      }));
      this.leftOut.impact = Object.keys(more);
    }
    if (safe_speed) {
      const { region, area, load, ...more } = safe_speed;
      const limit = LIMITS.find((name) => more[name] !== undefined) ?? DEFAULTS.limit;
      Object.assign(texts, { ...given({ area, load }), region: text(region), limit, limitValue: text(more[limit]) });
      this.leftOut.safe = Object.keys(more).filter((key) => key !== limit);
    }
    this.set(texts);
  }

  /** Requests all displayed results, unless they belong to the current study. A later call cancels an earlier one. */
  async refresh() {
    const { study, state } = this.present();
    if (!study || this.study === study) return;
    const kinds = this.wanted();
    if (!kinds.length) return;
    const run = ++this.run;
    for (const kind of kinds) {
      const result = await this.one(kind, study, state);
      if (run !== this.run || this.present().study !== study) return;
      this.results = { ...this.results, [kind]: result };
      this.changed();
    }
    this.study = study;
    this.changed();
  }

  private one(kind: Kind, study: Study, state: Record<string, number>): Promise<Outcome<unknown> | undefined> {
    const s = this.settings;
    switch (kind) {
      case 'damper': return this.ask({
        do: 'damp', question: study,
        damping: {
          restitution: number(s.restitution), stiffness: value(s.stiffness), ...(s.speed.trim() ? { speed: value(s.speed) } : {}), law: s.law, for: [s.tool],
          ...(s.stop ? { limit: s.stop } : {}), ...s.further,
        },
      });
      case 'impact': return this.ask({
        do: 'impact', question: study,
        impact: {
          restitution: number(s.impactRestitution), speed: value(s.impactSpeed.trim() || '1 m/s'),
          ...(s.impactStiffness.trim() ? { stiffness: value(s.impactStiffness) } : {}), ...(s.impactInTime ? { in_time: true } : {}),
        },
      });
      case 'safe': return this.ask({
        do: 'safe-speed', question: study,
        safe_speed: {
          ...(s.region ? { region: s.region } : {}), ...(s.limitValue.trim() ? { [s.limit]: value(s.limitValue) } : {}),
          ...(s.limit === 'pressure' ? { area: value(s.area) } : {}), load: value(s.load.trim() || '0'),
        },
      });
      case 'kinematics': return this.ask({ do: 'kinematics', model: study.model, state });
      case 'directions': return this.ask({ do: 'directions', question: study });
      case 'map': return this.map(study);
    }
  }

  private async map(study: Study): Promise<Outcome<Results['map']> | undefined> {
    const found: Results['map'] = new Map();
    const run = this.run;
    for (const { link, name, contacts } of this.facets) {
      if (study.contact.against === name) continue;
      const masses: GivenContact[] = [];
      for (let from = 0; from < contacts.length; from += FACETS_AT_ONCE) {
        const reply = await this.ask<GivenContact[]>({ do: 'map', question: study, link: name, contacts: contacts.slice(from, from + FACETS_AT_ONCE) });
        if (run !== this.run || !reply) return undefined;
        if ('refused' in reply) return reply;
        masses.push(...reply.ok);
      }
      found.set(link, masses);
    }
    return { ok: found };
  }
}

/** Names of the limits of a safe speed. */
export const LIMITS = ['force', 'pressure', 'energy', 'momentum'];

/** Value of a study as the text of a field. */
const text = (value: unknown) => (value === undefined || value === null ? '' : String(value));
/** Appends the default unit of a study to a number; a text already contains its unit. */
const withUnit = (value: unknown, unit: string) => (typeof value === 'number' ? `${value} ${unit}` : value);
const given = (values: Table) => Object.fromEntries(Object.entries(values).filter(([, value]) => value !== undefined).map(([key, value]) => [key, text(value)]));
const number = (text: string) => (Number.isFinite(Number(text)) && text.trim() !== '' ? Number(text) : text);
/** Number or quantity with a unit, as a study has it. */
const value = number;
