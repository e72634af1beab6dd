//! All integration tests, in one program: linking it once is most of what they cost.

mod any_bits;
mod bad_cases;
mod bad_requests;
mod book;
mod cases;
mod commands;
mod dependencies;
mod draw;
mod exact;
mod exact_cases;
mod help;
mod judge;
mod oracle_on_cases;
mod pictures;
mod pipes;
mod portable;
mod process;
mod readme;
mod regimes;
mod seeds;
mod shown;
mod slips;
mod trade;
mod transcripts;
mod who_loses_more;
mod workbench;

/// Compares a text with the committed `snapshots/NAME.snap`.
///
/// `INSTA_UPDATE=always cargo test -p tests` accepts what came; then read it.
fn assert_snapshot(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}
