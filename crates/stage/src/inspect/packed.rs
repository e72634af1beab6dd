//! Bytes as a page can hold them: compressed (zlib, RFC 1950), then in letters (base64, RFC 4648).

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// The 64 letters.
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Packs what is written to it, and hands it on as it comes: nothing is kept but some kilobytes.
pub struct Packed<W: Write>(ZlibEncoder<Base64<W>>);

impl<W: Write> Packed<W> {
    /// Hands what it packs to `page`.
    pub fn new(page: W) -> Packed<W> {
        Packed(ZlibEncoder::new(Base64::new(page), Compression::default()))
    }

    /// Writes what is left. Without it the end is missing.
    ///
    /// The error of `page`, as of every write.
    pub fn finish(self) -> io::Result<()> {
        self.0.finish()?.finish()
    }
}

impl<W: Write> Write for Packed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Writes three bytes as four letters.
pub(super) struct Base64<W: Write> {
    page: W,
    /// Bytes that wait for others, at most two.
    waiting: [u8; 3],
    count: usize,
}

impl<W: Write> Base64<W> {
    pub(super) fn new(page: W) -> Base64<W> {
        Base64 { page, waiting: [0; 3], count: 0 }
    }

    /// Writes what is left: one or two bytes as four signs, of which `=` stand for none.
    pub(super) fn finish(mut self) -> io::Result<()> {
        if self.count == 0 {
            return Ok(());
        }
        self.waiting[self.count..].fill(0);
        let mut letters = letters(self.waiting);
        letters[self.count + 1..].fill(b'=');
        self.page.write_all(&letters)
    }
}

impl<W: Write> Write for Base64<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for &byte in bytes {
            self.waiting[self.count] = byte;
            self.count += 1;
            if self.count == 3 {
                // whoever goes on after an error finds room for the next byte
                self.count = 0;
                self.page.write_all(&letters(self.waiting))?;
            }
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.page.flush()
    }
}

/// Six bits a letter, the first ones first.
fn letters([a, b, c]: [u8; 3]) -> [u8; 4] {
    let bits = u32::from_be_bytes([0, a, b, c]);
    [18, 12, 6, 0].map(|shift| LETTERS[(bits >> shift & 63) as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test vectors of RFC 4648, section 10.
    #[test]
    fn three_bytes_are_four_letters() {
        for (bytes, want) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            let mut text = Vec::new();
            let mut base64 = Base64::new(&mut text);
            // in whatever pieces
            bytes.as_bytes().chunks(2).for_each(|piece| base64.write_all(piece).unwrap());
            base64.finish().unwrap();
            assert_eq!(text, want.as_bytes(), "{bytes}");
        }
    }

    /// A page that is full from the first.
    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    /// The packer tries once more when it is dropped.
    #[test]
    fn a_page_that_is_full_is_an_error() {
        let mut packed = Packed::new(Full);
        let written = packed.write_all(b"a ray").and_then(|()| packed.finish());
        assert_eq!(written.unwrap_err().kind(), io::ErrorKind::StorageFull);
    }
}
