//! The kinds of ray and deformed object, and what the notes' methods lose in each.

use lab::Notes::Hold;
use lab::Regime;

/// Every regime of the chapter, the ordinary one first.
pub fn regimes() -> Vec<Regime<19>> {
    vec![Regime {
        name: "ordinary",
        what: "a sphere as it is",
        draw: |draw| {
            let x = draw.uniform(-1.5, 1.5);
            [x, 0.0, -5.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
        },
        notes: Hold("nothing is lost yet"),
    }]
}
