import { format } from '../../bench/src/tables.ts';
import { type Html, html } from './html.ts';

/** One line of a chart: points in the units of the axes. */
export interface Line {
  readonly label: string;
  readonly points: readonly (readonly [x: number, y: number])[];
}

/** A chart of lines over two axes, each linear or logarithmic. */
export interface LineChart {
  readonly title: string;
  readonly x: Axis;
  readonly y: Axis;
  readonly lines: readonly Line[];
  /** The label of the line that stands out. */
  readonly own: string;
}

export interface Axis {
  readonly label: string;
  readonly logarithmic?: boolean;
  readonly ticks: readonly number[];
}

const WIDTH = 720;
const HEIGHT = 380;
const LEFT = 58;
const RIGHT = 170;
const TOP = 16;
const BOTTOM = 46;
const LINE_HEIGHT = 15;

/** Where a value lies between the outermost ticks of an axis, 0 to 1. */
function place({ ticks, logarithmic }: Axis, value: number): number {
  const scale = logarithmic ? Math.log : (number: number) => number;
  const least = scale(ticks[0]);
  const most = scale(ticks[ticks.length - 1]);
  return Math.min(1, Math.max(0, (scale(value) - least) / (most - least)));
}

/** A chart as a drawing whose colours are those of the page; each line is named at its end. */
export function lineChart({ title, x, y, lines, own }: LineChart): Html {
  const toX = (value: number): number => LEFT + place(x, value) * (WIDTH - LEFT - RIGHT);
  const toY = (value: number): number => HEIGHT - BOTTOM - place(y, value) * (HEIGHT - TOP - BOTTOM);
  const shown = lines
    .map(({ label, points }) => ({ label, points: points.filter(([, value]) => Number.isFinite(value)) }))
    .filter(({ points }) => points.length > 0);
  const labels = spread(shown.map(({ label, points }) => ({ label, y: toY(points[points.length - 1][1]) })));
  const text = (at: number, on: number, anchor: string, content: string): Html =>
    html`<text x="${at}" y="${on}" text-anchor="${anchor}">${content}</text>`;
  return html`<figure class="chart">
<figcaption>${title}</figcaption>
<svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${title}: ${y.label} over ${x.label}">
${y.ticks.map((tick) => html`<path class="grid" d="M${LEFT} ${toY(tick)}H${WIDTH - RIGHT}"/>${text(LEFT - 8, toY(tick) + 4, 'end', tick < 0.01 ? format(tick) : String(tick))}`)}
${x.ticks.map((tick) => text(toX(tick), HEIGHT - BOTTOM + 20, 'middle', tick.toLocaleString('en')))}
${text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 6, 'middle', x.label)}${text(LEFT, TOP - 4, 'start', y.label)}
${shown.map(({ label, points }) => html`<path class="${label === own ? 'own line' : 'line'}" d="M${points.map(([a, b]) => `${toX(a).toFixed(1)} ${toY(b).toFixed(1)}`).join('L')}"><title>${label}</title></path>`)}
${labels.map(({ label, y: on }) => html`<text class="${label === own ? 'own' : ''}" x="${WIDTH - RIGHT + 8}" y="${(on + 4).toFixed(1)}">${label}</text>`)}
</svg>
</figure>
`;
}

/** Labels moved apart, in their order, so that each can be read, and none below the chart. */
function spread(labels: readonly { label: string; y: number }[]): { label: string; y: number }[] {
  const sorted = labels.toSorted((a, b) => a.y - b.y).map((label) => ({ ...label }));
  for (let i = 1; i < sorted.length; i++) sorted[i].y = Math.max(sorted[i].y, sorted[i - 1].y + LINE_HEIGHT);
  let lowest = HEIGHT - BOTTOM + 4;
  for (const label of sorted.toReversed()) {
    label.y = Math.min(label.y, lowest);
    lowest = label.y - LINE_HEIGHT;
  }
  return sorted;
}

/** One engine in a chart of dots. */
export interface Dot {
  readonly label: string;
  readonly value: number;
  readonly cells: readonly string[];
  readonly remark: string;
  /** Whether the value counts. */
  readonly sound: boolean;
}

/** A table whose first number is also a dot on a logarithmic scale, the least to the left. */
export function dotTable(caption: string, head: readonly string[], dots: readonly Dot[], own: string): Html {
  const values = dots.map(({ value }) => value).filter((value) => value > 0 && value < Infinity);
  const ticks = [Math.min(...values) / 1.15, Math.max(...values) * 1.15];
  const at = (value: number): string => (100 * place({ label: '', ticks, logarithmic: true }, value)).toFixed(1);
  return html`<div class="scroll" tabindex="0" role="group" aria-label="${caption}"><table class="dots">
<caption>${caption}</caption>
<thead><tr><th>engine</th><th class="track" aria-hidden="true"></th>${head.map((title) => html`<th>${title}</th>`)}<th></th></tr></thead>
<tbody>
${dots.map(
  ({
    label,
    value,
    cells,
    remark,
    sound,
  }) => html`<tr class="${label === own ? 'own' : ''} ${sound ? '' : 'unsound'}"><th scope="row">${label}</th><td class="track" aria-hidden="true">${Number.isFinite(value) && html`<i style="left: ${at(value)}%"></i>`}</td>${cells.map((cell) => html`<td>${cell}</td>`)}<td class="remark">${remark}</td></tr>
`,
)}</tbody>
</table></div>
`;
}
