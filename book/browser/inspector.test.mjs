// The inspectors: every pixel is shown by pointer, by keyboard and by number.

import assert from "node:assert/strict";
import { basename } from "node:path";
import { test } from "node:test";
import { open, others, withBrowser } from "./browser.mjs";

withBrowser();

test("there are inspectors, where pages beside the book are read", () => {
    assert.ok(others.length === 0 || others.some(page => page.endsWith("-inspect.html")), others.join(" "));
});

for (const file of others.filter(page => page.endsWith("-inspect.html"))) {
    test(`${basename(file)} shows the pixel that is asked for`, async () => {
        const { page, faults, close } = await open(file);
        const shown = pixel => page.locator(`#steps[data-pixel="${pixel}"]`).waitFor();
        const frame = page.locator("#frame");
        const { width, height } = await frame.boundingBox();
        const [columns, rows] = await frame.evaluate(({ dataset }) => [dataset.width, dataset.height].map(Number));
        const [cell, half] = [width / columns, height / rows / 2];

        await frame.hover({ position: { x: 2.5 * cell, y: 7 * half } });
        await shown("2,3");
        await frame.focus();
        await page.keyboard.press("ArrowRight");
        await page.keyboard.press("ArrowDown");
        await shown("3,4");
        await page.keyboard.press("Shift+ArrowRight");
        await shown("13,4");
        for (const pixel of ["0,0", `${columns - 1},${rows - 1}`]) {
            await page.locator("#pixel").fill(pixel);
            await shown(pixel);
            assert.ok(await page.locator("#steps tbody tr").count() > 3);
            assert.ok(await page.locator("#ray").evaluate(drawing => drawing.childElementCount) > 0);
        }
        assert.deepEqual(faults, []);
        await close();
    });
}
