// A table of words is a list on a narrow window (book.css draws it so): its rows one below the other, each cell after
// the head of its column. A table of numbers stays as it is, since its columns are compared.
window.addEventListener("DOMContentLoaded", () => {
    const WORDS = 40; // signs that no number has
    for (const table of document.querySelectorAll(".table-wrapper > table")) {
        const cells = [...table.tBodies].flatMap(body => [...body.rows].flatMap(row => [...row.cells]));
        if (!cells.some(cell => cell.textContent.length > WORDS)) continue;
        const heads = [...table.tHead.rows[0].cells].map(cell => cell.textContent);
        table.classList.add("words");
        // a browser that draws a table as a list no longer calls it a table
        table.setAttribute("role", "table");
        for (const row of table.rows) row.setAttribute("role", "row");
        for (const head of table.tHead.rows[0].cells) head.setAttribute("role", "columnheader");
        for (const cell of cells) {
            cell.setAttribute("role", "cell");
            cell.dataset.head = heads[cell.cellIndex];
        }
    }
});
