// Section that is closed at first; its content is rendered only while it is open, because each result renders it again.

import { useState } from 'preact/hooks';
import type { ComponentChildren } from 'preact';

export function Details({ title, startsOpen = false, content }: { title: string; startsOpen?: boolean; content(): ComponentChildren }) {
  const [open, setOpen] = useState(startsOpen);
  return (
    <details open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary><h2>{title}</h2></summary>
      {open ? content() : null}
    </details>
  );
}
