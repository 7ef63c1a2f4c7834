// Answers by tab: result, design, kinematics or safe speed, impact and damper. Closed tabs stay in the page, with what was typed in them.

import { useEffect, useRef } from 'preact/hooks';
import type { ComponentChildren } from 'preact';
import type { Tab } from '../model/answers';
import { toHash } from '../model/link';
import { store } from '../model/store';
import { saveSheet } from './away';
import { Changes } from './changes';
import { DamperPanel, ImpactPanel, KinematicsPanel, SafeSpeedPanel } from './further';
import { useStore } from './hooks';
import { ContactPanel, PosePanel } from './question';
import { Contributions, Hardpoints, Masses, Ratios } from './tables';

/** Largest number of drivers whose sliders are above the tabs: travel, roll and steer of an axle. */
const FEW_DRIVERS = 3;
/** Width of a phone, as in the style sheet. */
const PHONE = '(max-width: 760px)';

export function Tabs() {
  const { scene, drivers, answers } = useStore();
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const side = list.current!.parentElement!;
    const result = side.querySelector<HTMLElement>('.result')!;
    const watch = new ResizeObserver(() => side.style.setProperty('--under-result', `${result.offsetHeight}px`));
    watch.observe(result);
    return () => watch.disconnect();
  }, []);
  const isSheet = !!scene!.sheet;
  const hasKinematics = isSheet && scene!.motions.length > 0;
  const isFew = drivers.length <= FEW_DRIVERS;
  const every: [Tab, string, () => ComponentChildren][] = [
    ['result', 'Result', () => <><Contributions /><ContactPanel />{isFew ? null : <PosePanel />}{hasKinematics ? null : <Ratios />}<Changes /></>],
    ['design', 'Design', () => <><SaveSheet /><Hardpoints /><Masses /></>],
    ['kinematics', 'Kinematics', () => <><Ratios /><KinematicsPanel /></>],
    ['safe', 'Safe speed', () => <SafeSpeedPanel />],
    ['impact', 'Impact & damper', () => <><ImpactPanel /><DamperPanel /></>],
  ];
  const all = every.filter(([tab]) => (tab !== 'kinematics' || hasKinematics) && (tab !== 'safe' || !isSheet));
  const now = all.some(([tab]) => tab === answers.tab) ? answers.tab : 'result';
  const turn = (tab: Tab) => {
    answers.turnTo(tab);
    void toHash(store.linked()).then((hash) => history.replaceState(null, '', hash));
    // On a phone the tabs are at the lower edge of the screen, at any part of the page.
    if (matchMedia(PHONE).matches) requestAnimationFrame(() => document.getElementById(`answer-${tab}`)!.scrollIntoView());
  };
  const key = (event: KeyboardEvent) => {
    const at = all.findIndex(([tab]) => tab === now);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: all.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const [tab] = all[(to + all.length) % all.length];
    turn(tab);
    document.getElementById(`tab-${tab}`)!.focus();
  };
  return (
    <>
      {isFew ? <PosePanel /> : null}
      <div ref={list} class="answers" role="tablist" aria-label="Answers" onKeyDown={key}>
        {all.map(([tab, label]) => (
          <button key={tab} id={`tab-${tab}`} role="tab" aria-selected={tab === now} aria-controls={`answer-${tab}`} tabIndex={tab === now ? 0 : -1} onClick={() => turn(tab)}>{label}</button>
        ))}
      </div>
      {all.map(([tab, , content]) => (
        <div key={tab} id={`answer-${tab}`} class="answer" role="tabpanel" aria-labelledby={`tab-${tab}`} hidden={tab !== now}>{content()}</div>
      ))}
    </>
  );
}

/** Button that saves a changed design. */
function SaveSheet() {
  const { study, scene } = useStore();
  const { move, link_mass, link_inertia } = study!.model;
  const count = [move, link_mass, link_inertia].reduce((sum, table) => sum + Object.keys(table ?? {}).length, 0);
  if (!scene!.sheet?.hardpoints.length || !count) return null;
  return <p class="row"><button onClick={saveSheet}>Save the sheet ({count} {count === 1 ? 'change' : 'changes'})</button></p>;
}
