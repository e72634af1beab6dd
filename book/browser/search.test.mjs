// The search of the book, from disk.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { book, open, withBrowser } from "./browser.mjs";

withBrowser();

test("a word is found, and leads to a page that has it", async () => {
    const { page, faults, close } = await open(join(book, "index.html"));
    await page.locator("body").press("s");
    await page.locator("#mdbook-searchbar").and(page.locator(":focus")).waitFor();
    await page.keyboard.type("watertight");
    const first = page.locator("#mdbook-searchresults a").first();
    await first.waitFor();
    await first.click();
    await page.waitForLoadState("load");
    assert.match(await page.locator("main").innerText(), /watertight/i);
    assert.deepEqual(faults, []);
    await close();
});

test("what is nowhere is not found", async () => {
    const { page, close } = await open(join(book, "index.html"));
    await page.locator("body").press("s");
    await page.locator("#mdbook-searchbar").and(page.locator(":focus")).waitFor();
    await page.keyboard.type("zyzzyva");
    await page.locator("#mdbook-searchresults-header", { hasText: /no (search )?results/i }).waitFor();
    assert.equal(await page.locator("#mdbook-searchresults a").count(), 0);
    await close();
});
