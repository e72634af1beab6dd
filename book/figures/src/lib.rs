//! The chapters' interactive figures, for a page in a browser.
//!
//! A chapter has a [`Figure`]; [`exports!`](crate::exports) makes a module of it, with plain functions that
//! `book/theme/figures.js` calls. What a function has to say is UTF-8 text, which begins where the function
//! says and is [`length`](Shown::length) bytes long. It stays there until the next call.

mod values;

use stage::figure::{Dial, Figure};
use stage::{Sketch, escaped};

pub use values::values;

/// A figure as a reader sees it now.
#[derive(Debug, Default)]
pub struct Shown<F> {
    figure: F,
    method: usize,
    said: String,
}

impl<F: Figure> Shown<F> {
    /// Drags a handle to a place of the drawing.
    pub fn drag(&mut self, handle: usize, x: f64, y: f64) {
        let place = self.sketch().plane((x, y));
        self.figure.drag(handle, place);
    }

    /// Moves a handle by so much of the plane's units. Along an axis by 0 it stays where it is, to the last digit.
    pub fn nudge(&mut self, handle: usize, dx: f64, dy: f64) {
        if let Some(handle_is) = self.figure.handles().get(handle) {
            let (x, y) = handle_is.place;
            self.figure.drag(handle, (x + dx, y + dy));
        }
    }

    /// Turns a dial.
    pub fn turn(&mut self, dial: usize, to: f64) {
        self.figure.turn(dial, to);
    }

    /// Chooses the method whose steps are shown.
    pub fn choose(&mut self, method: usize) {
        if method < F::methods().len() {
            self.method = method;
        }
    }

    /// Begins anew.
    pub fn reset(&mut self) {
        self.figure = F::default();
    }

    /// What stands within the drawing: SVG.
    pub fn drawing(&mut self) -> *const u8 {
        let mut sketch = self.sketch();
        self.figure.draw(&mut sketch);
        for (number, handle) in self.figure.handles().into_iter().enumerate() {
            sketch.handle(handle.place, number, handle.name);
        }
        self.say(sketch.into_svg())
    }

    /// The method's steps and all answers: HTML.
    pub fn values(&mut self) -> *const u8 {
        let text = values(&self.figure, self.method);
        self.say(text)
    }

    /// The choice of a method and the dials: HTML.
    pub fn controls(&mut self) -> *const u8 {
        let mut text = String::from("<label>method <select data-method>");
        for (place, name) in F::methods().into_iter().enumerate() {
            let chosen = if place == self.method { " selected" } else { "" };
            text += &format!("<option value=\"{place}\"{chosen}>{name}</option>");
        }
        text += "</select></label>";
        for (place, Dial { name, value, least, most }) in self.figure.dials().into_iter().enumerate() {
            text += &format!(
                "<label>{name} <input type=\"range\" data-dial=\"{place}\" min=\"{least}\" \
                 max=\"{most}\" step=\"0.01\" \
                 value=\"{value}\"><output>{value}</output></label>"
            );
        }
        text += "<button type=\"button\" data-reset>Begin anew</button>";
        self.say(text)
    }

    /// What to move: text.
    pub fn caption(&mut self) -> *const u8 {
        self.say(escaped(F::CAPTION))
    }

    /// How many bytes the last text has.
    pub fn length(&self) -> usize {
        self.said.len()
    }

    fn sketch(&self) -> Sketch {
        let (low, high) = F::FRAME;
        Sketch::new(low, high)
    }

    fn say(&mut self, text: String) -> *const u8 {
        self.said = text;
        self.said.as_ptr()
    }
}

/// Exports a chapter's figure from a module: one state, and a function for each thing that a reader does.
#[macro_export]
macro_rules! exports {
    ($figure:ty) => {
        use std::cell::RefCell;

        thread_local! {
            static SHOWN: RefCell<$crate::Shown<$figure>> = RefCell::default();
        }

        $crate::exports! { @each
            drag(handle: usize, x: f64, y: f64);
            nudge(handle: usize, dx: f64, dy: f64);
            turn(dial: usize, to: f64);
            choose(method: usize);
            reset();
            drawing() -> *const u8;
            values() -> *const u8;
            controls() -> *const u8;
            caption() -> *const u8;
            length() -> usize;
        }
    };
    (@each $($name:ident($($argument:ident: $type:ty),*) $(-> $result:ty)?;)*) => {$(
        #[expect(unsafe_code, reason = "a name that a page can call is not mangled")]
        #[unsafe(no_mangle)]
        extern "C" fn $name($($argument: $type),*) $(-> $result)? {
            SHOWN.with_borrow_mut(|shown| shown.$name($($argument),*))
        }
    )*};
}

#[cfg(test)]
mod tests;
