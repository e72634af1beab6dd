// One browser for a file of tests, and what a page complains of while it is read.

import { readdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before } from "node:test";
import { chromium } from "playwright-core";

export const book = process.env.BOOK;

// Every page of the book that a reader can come to: not what mdBook makes for its own frames and for servers.
export const chapters = readdirSync(book, { recursive: true })
    .filter(file => file.endsWith(".html") && !["404.html", "toc.html"].includes(file))
    .map(file => join(book, file))
    .sort();

// Pages beside the book: the gallery, inspectors.
export const others = (process.env.PAGES ?? "").split(":").filter(page => page !== "");

let browser;

// Starts the browser before the tests of a file, and ends it after them.
export function withBrowser() {
    before(async () => {
        browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox"] });
    });
    after(() => browser.close());
}

// Opens a page as a reader does who has the folder alone. `faults` fills with what goes wrong: errors on the
// console, errors of scripts, and whatever is asked of a network.
export async function open(file, { width = 1200, height = 900, scheme = "light" } = {}) {
    const context = await browser.newContext({ viewport: { width, height }, colorScheme: scheme });
    const page = await context.newPage();
    const faults = [];
    page.on("console", message => {
        if (message.type() === "error") faults.push(message.text());
    });
    page.on("pageerror", error => faults.push(String(error)));
    page.on("requestfailed", request => faults.push(`not there: ${request.url()}`));
    page.on("request", request => {
        if (!/^(file|data|blob):/.test(request.url())) faults.push(`a request to a network: ${request.url()}`);
    });
    await page.goto(pathToFileURL(file).href, { waitUntil: "load" });
    // what a script unpacks is there a moment later
    for (const [holder, content] of [["[data-figure]", ".interactive .handle"], ["#steps", "#steps[data-pixel]"]]) {
        if (await page.locator(holder).count() > 0) await page.locator(content).first().waitFor();
    }
    return { page, faults, close: () => context.close() };
}
