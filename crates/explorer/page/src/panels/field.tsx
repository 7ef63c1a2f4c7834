// Number field: typed, or stepped by arrows; one gesture lasts from the first change to the blur.

import { useRef, useState } from 'preact/hooks';
import { store } from '../model/store';

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
  const open = useRef(false);
  const shown = Number(value.toFixed(decimals)) + 0;
  const apply = (x: number) => {
    if (!Number.isFinite(x)) return;
    if (!open.current) store.begin(label);
    open.current = true;
    set(x);
  };
  const close = () => {
    setText(undefined);
    if (open.current) store.finish();
    open.current = false;
  };
  return (
    <input
      type="text" inputMode="decimal" autocomplete="off" class={changed ? 'number changed' : 'number'} aria-label={label} title={title}
      disabled={disabled} value={text ?? shown.toFixed(decimals)}
      onInput={(event) => {
        const typed = event.currentTarget.value;
        setText(typed);
        const number = Number(typed.replace(',', '.').replace('−', '-'));
        if (typed.trim() !== '') apply(number);
      }}
      onKeyDown={(event) => {
        const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (way) {
          event.preventDefault();
          setText(undefined);
          const by = step * (event.shiftKey ? 10 : 1);
          apply(Math.round((value + way * by) / step) * step);
        } else if (event.key === 'Enter') {
          close();
        } else if (event.key === 'Escape' && open.current) {
          event.stopPropagation();
          setText(undefined);
          open.current = false;
          store.finish(false);
        }
      }}
      onBlur={close}
    />
  );
}

export function Slider({ label, value, range, step, set, text, disabled }: {
  label: string; value: number; range: [number, number]; step: number; text: string; disabled?: boolean; set(value: number): void;
}) {
  const open = useRef(false);
  const close = () => {
    if (open.current) store.finish();
    open.current = false;
  };
  return (
    <input
      type="range" aria-label={label} aria-valuetext={text} min={range[0]} max={range[1]} step="any" value={value} disabled={disabled}
      onInput={(event) => {
        if (!open.current) store.begin(label);
        open.current = true;
        set(Math.round(Number(event.currentTarget.value) / (step / 5)) * (step / 5));
      }}
      onKeyDown={(event) => {
        const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
        if (way === undefined && event.key !== 'Home' && event.key !== 'End') return;
        event.preventDefault();
        if (!open.current) store.begin(label);
        open.current = true;
        const to = way === undefined ? range[event.key === 'Home' ? 0 : 1] : value + way * step * (event.shiftKey ? 10 : 1);
        set(Math.min(Math.max(Math.round(to / step) * step, range[0]), range[1]));
      }}
      onKeyUp={close} onChange={close} onBlur={close}
    />
  );
}
