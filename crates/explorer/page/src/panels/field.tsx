// Number field and slider: one gesture lasts from the first change to the end of the input.

import { useRef, useState } from 'preact/hooks';
import { store } from '../model/store';

/** Gesture of an input. Repeated keys step from the last value of the gesture, because the page is rendered later than a key is pressed. */
function useGesture(label: string, value: number, set: (value: number) => void) {
  const last = useRef<number | undefined>(undefined);
  const end = (keep: boolean) => {
    if (last.current !== undefined) store.finish(keep);
    last.current = undefined;
  };
  return {
    isOpen: () => last.current !== undefined,
    from: () => last.current ?? value,
    apply: (x: number) => {
      if (!Number.isFinite(x)) return;
      if (last.current === undefined) store.begin(label);
      last.current = x;
      set(x);
    },
    end,
  };
}

interface Props {
  label: string;
  value: number;
  decimals: number;
  step: number;
  title?: string;
  changed?: boolean;
  disabled?: boolean;
  set(value: number): void;
}

export function NumberField({ label, value, decimals, step, title, changed, disabled, set }: Props) {
  const [text, setText] = useState<string | undefined>(undefined);
  const gesture = useGesture(label, value, set);
  const shown = Number(value.toFixed(decimals)) + 0;
  const close = () => {
    setText(undefined);
    gesture.end(true);
  };
  return (
    <input
      type="text" inputMode="decimal" autocomplete="off" class={changed ? 'number changed' : 'number'} aria-label={label} title={title}
      disabled={disabled} value={text ?? shown.toFixed(decimals)}
      onInput={(event) => {
        const typed = event.currentTarget.value;
        setText(typed);
        const number = Number(typed.replace(',', '.').replace('−', '-'));
        if (typed.trim() !== '') gesture.apply(number);
      }}
      onKeyDown={(event) => {
        const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (way) {
          event.preventDefault();
          setText(undefined);
          const by = step * (event.shiftKey ? 10 : 1);
          gesture.apply(Math.round((gesture.from() + way * by) / step) * step);
        } else if (event.key === 'Enter') {
          close();
        } else if (event.key === 'Escape' && gesture.isOpen()) {
          event.stopPropagation();
          setText(undefined);
          gesture.end(false);
        }
      }}
      onBlur={close}
    />
  );
}

/** Text that is set when the input ends; until then, a rendering of the page leaves the typed text. */
export function TextField({ label, value, hint, class: of, set }: { label?: string; value: string; hint?: string; class: string; set(text: string): void }) {
  const [text, setText] = useState<string | undefined>(undefined);
  return (
    <input class={of} type="text" autocomplete="off" aria-label={label} placeholder={hint} value={text ?? value}
      onInput={(event) => setText(event.currentTarget.value)}
      onChange={(event) => {
        set(event.currentTarget.value);
        setText(undefined);
      }} />
  );
}

export function Slider({ label, value, range, step, set, text, disabled }: {
  label: string; value: number; range: [number, number]; step: number; text: string; disabled?: boolean; set(value: number): void;
}) {
  const gesture = useGesture(label, value, set);
  const close = () => gesture.end(true);
  return (
    <input
      type="range" aria-label={label} aria-valuetext={text} min={range[0]} max={range[1]} step="any" value={value} disabled={disabled}
      onInput={(event) => gesture.apply(Math.round(Number(event.currentTarget.value) / (step / 5)) * (step / 5))}
      onKeyDown={(event) => {
        const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
        if (way === undefined && event.key !== 'Home' && event.key !== 'End') return;
        event.preventDefault();
        const to = way === undefined ? range[event.key === 'Home' ? 0 : 1] : gesture.from() + way * step * (event.shiftKey ? 10 : 1);
        gesture.apply(Math.min(Math.max(Math.round(to / step) * step, range[0]), range[1]));
      }}
      onKeyUp={close} onChange={close} onBlur={close}
    />
  );
}
