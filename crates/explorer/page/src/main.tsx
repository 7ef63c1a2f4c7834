import { render } from 'preact';
import { App } from './app';
import { store } from './model/store';
import type { Start } from './model/link';

const start = JSON.parse(document.getElementById('start')!.textContent || '{}') as Start;
const app = document.getElementById('app')!;
app.replaceChildren();
render(<App />, app);
void store.start(start);
