/** Watches the size of elements, down to the device pixel. */
export interface PixelObserver {
  observe(element: HTMLElement): void;
  disconnect(): void;
}

/**
 * Calls back, before anything is painted, with the size of an element in CSS px and the device px in each of them, such that
 * their product is the whole number of device px that the browser gives the element: a canvas of as many is crisp.
 */
export function observePixels(
  resized: (element: Element, width: number, height: number, ratio: number) => void,
): PixelObserver {
  const observer = new ResizeObserver((entries) => {
    const ratio = window.devicePixelRatio;
    for (const { target, contentRect, devicePixelContentBoxSize } of entries) {
      // Some browsers do not tell, and where a device is emulated CSS px come under the other name: then it is guessed.
      const exact = devicePixelContentBoxSize?.[0];
      const sure = exact !== undefined && Math.abs(exact.inlineSize - contentRect.width * ratio) < 2;
      const width = sure ? exact.inlineSize : Math.round(contentRect.width * ratio);
      const height = sure ? exact.blockSize : Math.round(contentRect.height * ratio);
      resized(target, width / ratio, height / ratio, ratio);
    }
  });
  return {
    observe(element: HTMLElement): void {
      try {
        observer.observe(element, { box: 'device-pixel-content-box' });
      } catch {
        observer.observe(element);
      }
    },
    disconnect: () => observer.disconnect(),
  };
}
