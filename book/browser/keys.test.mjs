// The arrows: in what is wider than its place they scroll it, elsewhere they turn the page.

import assert from "node:assert/strict";
import { basename, join } from "node:path";
import { test } from "node:test";
import { book, open, withBrowser } from "./browser.mjs";

withBrowser();

test("an arrow scrolls the table that has the focus, and turns the page elsewhere", async () => {
    const { page, faults, close } = await open(join(book, "ray-sphere.html"), { width: 360 });
    const place = () => basename(new URL(page.url()).pathname);
    const wide = page.locator('main .table-wrapper[tabindex="0"]').first();
    await wide.focus();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(box => box.scrollLeft > 0, await wide.elementHandle());
    assert.equal(place(), "ray-sphere.html");
    await page.evaluate(() => document.activeElement.blur());
    await Promise.all([page.waitForURL(/triangle\.html/), page.keyboard.press("ArrowRight")]);
    assert.deepEqual(faults, []);
    await close();
});
