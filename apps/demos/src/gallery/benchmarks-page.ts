import { watchTheme } from './theme.ts';

watchTheme(() => {}); // the charts take their colours from the page
