// Kept variants with their differences from the design shown.

import { digits, fixed, signed } from '../model/numbers';
import { store } from '../model/store';
import { VARIANTS } from '../view/space';
import { useStore } from './hooks';

export function VariantTable() {
  const { variants, posed, problem } = useStore();
  if (!variants.length || !posed) return null;
  const { effective_mass: m, unit } = posed.report;
  return (
    <section class={problem ? 'stale' : ''}>
      <h2>Variants</h2>
      <table class="plain">
        <thead><tr><th>design</th><th>m̄, {unit}</th><th colSpan={2}>now − it, {unit}</th></tr></thead>
        <tbody>{variants.map((v) => {
          const by = m !== null && v.mass !== null ? m - v.mass : undefined;
          return (
            <tr key={v.name} class="variant">
              <th scope="row">
                <button title={`Back to variant ${v.name}`} onClick={() => store.change(v.study, `variant ${v.name}`)} style={{ color: VARIANTS[v.colour] }}>{v.name}</button>
                <button class="quiet" aria-label={`Remove variant ${v.name}`} onClick={() => store.set({ variants: variants.filter((o) => o !== v) })}>×</button>
              </th>
              <td class="n">{v.mass === null ? '–' : digits(v.mass)}</td>
              <td class="n difference">{by === undefined ? '–' : signed(by, Math.max(0, 3 - Math.floor(Math.log10(Math.max(m!, 1e-9)))))}</td>
              <td class="n soft">{by === undefined ? '' : `${by > 0 ? '+' : ''}${fixed((100 * by) / v.mass!, 2)} %`}</td>
            </tr>
          );
        })}</tbody>
      </table>
    </section>
  );
}
