// The interactive figures: a pointer, keys and dials change what they say, and nothing they do is an error.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { book, open, withBrowser } from "./browser.mjs";

withBrowser();

for (const name of ["ray-wall", "ray-plane", "ray-sphere", "triangle", "affine", "whitted"]) {
    const file = join(book, `${name}.html`);

    // A page with its figure there.
    async function withFigure(options) {
        const { page, faults, close } = await open(file, options);
        const figure = page.locator(".interactive[data-figure]");
        await figure.locator(".handle").first().waitFor();
        const values = () => figure.locator(".values").innerText();
        return { page, faults, close, figure, values };
    }

    test(`${name} answers to the keyboard`, async () => {
        const { page, faults, close, figure, values } = await withFigure();
        const start = await values();
        assert.match(start, /What each method answers/);
        for (const [number, handle] of (await figure.locator(".handle").all()).entries()) {
            await handle.focus();
            const said = await handle.getAttribute("aria-valuetext");
            for (const key of ["ArrowLeft", "ArrowUp"]) await page.keyboard.press(key);
            const held = page.locator(".handle:focus");
            assert.equal(await held.getAttribute("data-handle"), String(number), "it keeps the focus");
            assert.notEqual(await held.getAttribute("aria-valuetext"), said);
        }
        assert.notEqual(await values(), start);
        await figure.locator("[data-reset]").click();
        assert.equal(await values(), start);
        assert.deepEqual(faults, []);
        await close();
    });

    test(`${name} answers to a pointer`, async () => {
        const { page, faults, close, figure, values } = await withFigure();
        const handles = await figure.locator(".handle").count();
        for (let number = 0; number < handles; number += 1) {
            const start = await values();
            await figure.locator("svg").evaluate(drawing => drawing.scrollIntoView({ block: "center" }));
            const { x, y, width, height } = await figure.locator(`[data-handle="${number}"] .grip`).boundingBox();
            await page.mouse.move(x + width / 2, y + height / 2);
            await page.mouse.down();
            await page.mouse.move(x + 30, y + 25, { steps: 5 });
            await page.mouse.up();
            const there = await values();
            assert.notEqual(there, start, `handle ${number}`);
            await page.mouse.move(x + 90, y + 90);
            assert.equal(await values(), there, "what is let go stays");
        }
        assert.deepEqual(faults, []);
        await close();
    });

    test(`${name} shows every method, and its dials turn`, async () => {
        const { faults, close, figure, values } = await withFigure();
        const methods = await figure.locator("[data-method] option").allInnerTexts();
        for (const [place, method] of methods.entries()) {
            await figure.locator("[data-method]").selectOption(String(place));
            assert.ok((await values()).includes(`The steps of ${method}\n`), method);
        }
        for (const dial of await figure.locator("[data-dial]").all()) {
            const start = await values();
            await dial.fill("2.2");
            assert.notEqual(await values(), start);
        }
        assert.deepEqual(faults, []);
        await close();
    });

    test(`${name} fits a telephone`, async () => {
        const { page, close, figure } = await withFigure({ width: 360, height: 640 });
        const { width } = await figure.locator("svg").boundingBox();
        assert.ok(width <= 360 && width > 280, `the drawing is ${width} pixels wide`);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 360);
        await close();
    });
}
