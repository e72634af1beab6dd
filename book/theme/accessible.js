// What mdBook's own page leaves out, for those who listen to it: the switch of the table of contents says that it is
// one, the field of the search what it is for, and a table or a block of code that is wider than the window can be
// reached and scrolled by the keyboard.
window.addEventListener("DOMContentLoaded", () => {
    document.getElementById("mdbook-sidebar-toggle")?.setAttribute("role", "button");
    document.getElementById("mdbook-searchbar")?.setAttribute("aria-label", "Search this book");
    for (const box of document.querySelectorAll(".table-wrapper, main pre > code, .katex-display")) {
        if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    }
});
