// Words in the picture.

import { CanvasTexture, OrthographicCamera, Sprite, SpriteMaterial, SRGBColorSpace } from "three";

const MOST = 48; // letters
const PIXELS = 26;
const HEIGHT = 0.024; // of the picture's height, about

/** A text of constant size that faces the camera and is never hidden. */
export function label(text: string, color: string): Sprite {
  const shown = text.length > MOST ? `${text.slice(0, MOST - 1)}…` : text;
  const canvas = document.createElement("canvas");
  const pen = canvas.getContext("2d") as CanvasRenderingContext2D;
  const font = `500 ${PIXELS}px system-ui, sans-serif`;
  pen.font = font;
  canvas.width = Math.ceil(pen.measureText(shown).width) + PIXELS;
  canvas.height = Math.ceil(PIXELS * 1.5);
  pen.font = font;
  pen.fillStyle = "#ffffffe8";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.fillStyle = color;
  pen.textBaseline = "middle";
  pen.fillText(shown, PIXELS / 2, canvas.height / 2);
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, sizeAttenuation: false }));
  const scale = (height: number): void => {
    if (sprite.scale.y === height) return;
    sprite.scale.set((height * canvas.width) / canvas.height, height, 1);
    sprite.updateMatrixWorld();
  };
  scale(HEIGHT);
  // Without perspective a size is one of the world.
  sprite.onBeforeRender = (_renderer, _world, camera) =>
    scale(HEIGHT * (camera instanceof OrthographicCamera ? ((camera.top - camera.bottom) / camera.zoom) * 1.2 : 1));
  sprite.center.set(0.5, -0.8);
  sprite.renderOrder = 10;
  return sprite;
}

/** A length as people write it: three digits. */
export function meters(length: number): string {
  return length >= 1000 ? length.toFixed(0) : String(Number(length.toPrecision(3)));
}
