// Contacts as cards with their present effective masses, and a card that makes another contact.

import type { ListedContact, MassReport } from '../engine/protocol';
import { fixed, mass, words } from '../model/numbers';
import { store } from '../model/store';
import { useStore } from './hooks';

/** m̄ of a result as text. */
function value(report: MassReport | null | undefined): string {
  if (!report) return '–';
  if (report.status !== 'finite') return report.status === 'immovable' ? '∞' : '0 kg';
  return `${mass(report.effective_mass!, report.effective_mass_error, 4)} ${report.unit}`;
}

/** Pose of a result: the travel of the wheels at the touch of a stop. */
function place({ kind, report, problem }: ListedContact): string {
  if (kind !== 'stop') return 'design position';
  const named = report?.named_contact;
  if (problem || !named?.brought_to_touch) return problem ? 'not reached' : '';
  const travels = [...new Set(named.wheel_travel.map(({ travel }) => `${fixed(travel * 1000, 1)} mm`))];
  return travels.length ? `touch at ${travels.join(', ')}` : 'at the touch';
}

export function ContactCards() {
  const { study, contacts, posed, problem, opened, choosing } = useStore();
  if (!opened || !study) return null;
  const isFresh = store.contactsAreFresh;
  const isOwn = !study.contact.at || !contacts.some(({ name }) => name === study.contact.at);
  const choose = (name: string) => {
    const { travel, ...pose } = study.pose;
    void travel;
    store.change({ ...study, contact: { at: name }, pose }, `contact ${words(name)}`);
  };
  const card = (name: string, text: string, where: string, isChosen: boolean, isStale: boolean, onClick?: () => void) => (
    <button key={name} class={isStale ? 'card stale' : 'card'} data-contact-name={name} aria-pressed={isChosen} onClick={onClick} title={where}>
      <span class="soft">{words(name)}</span> <b>{text}</b> <small class="soft">{where}</small>
    </button>
  );
  return (
    <nav class="cards" aria-label="Contacts with their effective masses">
      <span class="soft cards-head">effective mass m̄<br />seen by the</span>
      {contacts.map((contact) => {
        const isChosen = contact.name === study.contact.at;
        // The card of the contact shown has the number of the result.
        const shown = isChosen && posed && !problem ? posed.report : contact.report;
        const isAway = isChosen && study.pose.travel?.length;
        return card(contact.name, value(shown), isAway ? 'at the travel shown' : place(contact), isChosen, isChosen ? !!problem : !isFresh, () => choose(contact.name));
      })}
      {isOwn ? card(study.contact.at ?? 'own contact', value(posed?.report), posed ? `on ${words(posed.report.contact.link)}` : '', true, !!problem) : null}
      <button class="card add" aria-pressed={choosing} onClick={() => store.set({ choosing: !choosing })}>{choosing ? 'click a link … (Esc)' : '+ contact: click a link'}</button>
    </nav>
  );
}
