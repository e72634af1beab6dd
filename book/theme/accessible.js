// What mdBook's own page leaves out, for those who listen to it or have no pointer: the switch of the table of
// contents says that it is one, the field of the search what it is for, and what is wider than its place can be
// reached and scrolled by the keyboard.
window.addEventListener("DOMContentLoaded", () => {
    document.getElementById("mdbook-sidebar-toggle")?.setAttribute("role", "button");
    document.getElementById("mdbook-searchbar")?.setAttribute("aria-label", "Search this book");
    const reach = () => {
        for (const box of document.querySelectorAll(".table-wrapper, main pre > code, .katex-display")) {
            if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
        }
    };
    reach();
    // once the letters of mathematics are there, and whenever the window changes
    for (const event of ["load", "resize"]) window.addEventListener(event, reach);
    document.fonts.ready.then(reach);
    // there the arrows scroll; elsewhere they turn the page
    document.body.addEventListener("keydown", event => {
        const box = event.target.closest?.('main [tabindex="0"]');
        if (["ArrowLeft", "ArrowRight"].includes(event.key) && box) event.stopPropagation();
    });
});
