//! What `trade` draws: the drawings of the full runs, which stand in the book as well.

/// A stage's name and its drawing.
macro_rules! drawn {
    ($($name:literal)*) => {
        [$(($name, include_str!(concat!("../../../book/src/trade/", $name, "-trade.svg")))),*]
    };
}

static ALL: [(&str, &str); 11] = drawn! {
    "pinhole" "ray-wall" "ray-plane" "ray-sphere" "triangle" "quadric" "affine" "signature" "bounds" "shading"
    "whitted"
};

/// Speed beside accuracy of the stage of this name, as SVG; `None` where there is no such stage.
pub(crate) fn trade_of(name: &str) -> Option<&'static str> {
    ALL.iter().find(|(stage, _)| *stage == name).map(|(_, svg)| *svg)
}

/// The width and height that a drawing gives itself, as it writes them.
pub(crate) fn size(svg: &str) -> Option<(&str, &str)> {
    let (_, root) = svg.split_once("<svg ")?;
    let (root, _) = root.split_once('>')?;
    let of = |name: &str| Some(root.split_once(name)?.1.split_once('"')?.0);
    Some((of(" width=\"")?, of(" height=\"")?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stages;

    #[test]
    fn every_stage_has_a_drawing_with_a_size() {
        assert_eq!(stages::names(), ALL.map(|(name, _)| name));
        for (name, svg) in ALL {
            let (width, height) = size(svg).unwrap();
            assert!(width.parse::<f64>().unwrap() > 0.0 && height.parse::<f64>().unwrap() > 0.0, "{name}");
        }
        assert_eq!(trade_of("nothing"), None);
    }
}
