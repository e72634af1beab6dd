// Draws each element of class `math` with KaTeX, which comes with the book.
window.addEventListener("DOMContentLoaded", () => {
    for (const element of document.querySelectorAll("span.math")) {
        const displayMode = element.classList.contains("display");
        katex.render(element.textContent, element, { displayMode, throwOnError: false, strict: "error" });
    }
});
