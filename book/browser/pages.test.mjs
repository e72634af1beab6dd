// Every page: nothing complains, every picture is there, mathematics is drawn, it fits its window, and whoever
// cannot see it well can read it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename } from "node:path";
import { test } from "node:test";
import { book, chapters, open, others, withBrowser } from "./browser.mjs";

withBrowser();

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

test("there are pages", () => {
    assert.ok(chapters.length >= 20, `${chapters.length} in ${book}`);
});

for (const file of [...chapters, ...others]) {
    const name = basename(file);

    test(`${name} opens from disk, whole`, async () => {
        const { page, faults, close } = await open(file);
        // a picture that waits until it is come to is asked for now
        await page.evaluate(() => [...document.images].forEach(image => { image.loading = "eager"; }));
        await page.waitForFunction(() => [...document.images].every(image => image.complete));
        const blank = await page.evaluate(() =>
            [...document.images].filter(image => image.naturalWidth === 0).map(image => image.src));
        assert.deepEqual(blank, [], "pictures that are not there");
        assert.deepEqual(faults, []);
        await close();
    });

    test(`${name} has its mathematics drawn`, async () => {
        const { page, close } = await open(file);
        const [asked, drawn, wrong] = await page.evaluate(() =>
            ["span.math", "span.math > .katex, span.math > .katex-display", ".katex-error"]
                .map(selector => document.querySelectorAll(selector).length));
        assert.equal(drawn, asked);
        assert.equal(wrong, 0);
        // what KaTeX keeps for screen readers and for copying is not seen
        const raw = await page.evaluate(() => {
            const seen = document.body.cloneNode(true);
            seen.querySelectorAll("script, style, pre, code, .katex, svg").forEach(element => element.remove());
            return seen.textContent.match(/\\(vec|bar|frac|cdot|sqrt|lVert)\b|\$[^$\n]+\$/g) ?? [];
        });
        assert.deepEqual(raw, [], "TeX that nobody drew");
        await close();
    });

    for (const width of [360, 1600]) {
        test(`${name} is readable ${width} pixels wide`, async () => {
            const { page, close } = await open(file, { width });
            const [wide, letters] = await page.evaluate(() => {
                const text = document.querySelector("main p") ?? document.querySelector("p") ?? document.body;
                return [widest(), parseFloat(getComputedStyle(text).fontSize)];

                // mdBook's page scrolls in a box of its own, which is never wider than the window
                function widest() {
                    const boxes = [document.documentElement, ...document.querySelectorAll(".content, main")];
                    return Math.max(...boxes.map(box => box.scrollWidth));
                }
            });
            assert.ok(wide <= width, `the page is ${wide} pixels wide: it has to be pushed to and fro`);
            assert.ok(letters >= 14, `letters of ${letters} pixels`);
            const pushed = await page.evaluate(() => [...document.querySelectorAll(".table-wrapper")]
                .filter(box => box.scrollWidth > box.clientWidth)
                .filter(box => [...box.querySelectorAll("td")].some(cell => cell.textContent.length > 60))
                .map(box => box.textContent.slice(0, 60)));
            assert.deepEqual(pushed, [], "sentences in a table that has to be pushed to and fro");
            await close();
        });
    }

    for (const scheme of ["light", "dark"]) {
        test(`${name} has no serious finding, ${scheme}`, async () => {
            const { page, close } = await open(file, { scheme });
            await page.evaluate(axe);
            const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
            const serious = found.violations
                .filter(({ impact }) => impact === "serious" || impact === "critical")
                .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html).join(" ")}`);
            assert.deepEqual(serious, []);
            await close();
        });
    }
}
