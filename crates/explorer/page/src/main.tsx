import { render } from 'preact';
import { App } from './app';
import { store, type Start } from './model/store';

const start = JSON.parse(document.getElementById('start')!.textContent || '{}') as Start;
const app = document.getElementById('app')!;
app.replaceChildren();
render(<App />, app);
void store.start(start);
