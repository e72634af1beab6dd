// The interactive figures. All numbers and all drawings are the chapter's own Rust, which the page holds as a packed
// module: what a pointer, a key or a dial does is handed to it, and what it says is put into the page.

// How far an arrow key moves a handle, in units of the drawn plane; with Shift, and without.
const FINE = 0.01, COARSE = 0.1;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

window.addEventListener("DOMContentLoaded", () => {
    for (const box of document.querySelectorAll("div.interactive[data-figure]")) start(box);
});

// Puts the figure in the place of the still picture. Where the browser has no modules, that stays.
async function start(box) {
    const packed = Uint8Array.from(atob(box.querySelector("script.module").textContent), sign => sign.charCodeAt(0));
    const unpacked = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const { instance } = await WebAssembly.instantiate(await new Response(unpacked).arrayBuffer());
    const chapter = instance.exports;
    const said = what => {
        const at = chapter[what]();
        return new TextDecoder().decode(new Uint8Array(chapter.memory.buffer, at, chapter.length()));
    };

    box.innerHTML =
        `<svg viewBox="0 0 480 320" role="group" aria-label="${box.dataset.figure}: an interactive figure"></svg>
         <p class="caption"></p><div class="controls"></div><div class="values"></div>`;
    const [drawing, caption, controls, values] = ["svg", ".caption", ".controls", ".values"]
        .map(part => box.querySelector(part));
    caption.innerHTML = `${said("caption")} A handle that has the focus is moved by the arrow keys, with Shift by less.`;
    const show = () => {
        const held = document.activeElement?.closest?.("[data-handle]")?.dataset.handle;
        drawing.innerHTML = said("drawing");
        values.innerHTML = said("values");
        if (held !== undefined && box.contains(drawing)) {
            drawing.querySelector(`[data-handle="${held}"]`)?.focus({ preventScroll: true });
        }
    };
    const showAll = () => {
        controls.innerHTML = said("controls");
        show();
    };

    let dragged = null;
    drawing.addEventListener("pointerdown", event => {
        const handle = event.target.closest("[data-handle]");
        if (!handle) return;
        dragged = Number(handle.dataset.handle);
        handle.focus({ preventScroll: true });
        drawing.setPointerCapture(event.pointerId);
        event.preventDefault();
    });
    drawing.addEventListener("pointermove", event => {
        if (dragged === null) return;
        const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing.getScreenCTM().inverse());
        chapter.drag(dragged, x, y);
        show();
    });
    for (const end of ["pointerup", "pointercancel"]) drawing.addEventListener(end, () => { dragged = null; });
    drawing.addEventListener("keydown", event => {
        const handle = event.target.closest("[data-handle]");
        const [dx, dy] = ARROWS[event.key] ?? [0, 0];
        if (!handle || (dx === 0 && dy === 0) || event.altKey || event.ctrlKey || event.metaKey) return;
        const step = event.shiftKey ? FINE : COARSE;
        chapter.nudge(Number(handle.dataset.handle), dx * step, dy * step);
        show();
        // the page neither scrolls nor turns
        event.preventDefault();
        event.stopPropagation();
    });
    controls.addEventListener("input", event => {
        const { dial } = event.target.dataset;
        if (dial !== undefined) {
            chapter.turn(Number(dial), Number(event.target.value));
            event.target.nextElementSibling.textContent = event.target.value;
        } else if ("method" in event.target.dataset) {
            chapter.choose(Number(event.target.value));
        }
        show();
    });
    controls.addEventListener("click", event => {
        if (!("reset" in event.target.dataset)) return;
        chapter.reset();
        showAll();
    });
    showAll();
}
