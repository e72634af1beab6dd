//! Real submissions, some of them hostile, graded as a class. Where there is no sandbox they are skipped with
//! a word; in `.ci/full` it has to be there (`SANDBOX=required`).

mod class;
mod hostile;
mod of_the_book;
mod ordinary;
