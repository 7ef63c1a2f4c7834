// Section that is closed initially. Its content is rendered only while the section is open, because each result renders it again.

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
