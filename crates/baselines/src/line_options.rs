//! What the line methods of this crate share of their options: width, ink and interior.

/// The options struct of a method that draws lines: its own fields, then those that all have; with feature `gpu` also `line_style`,
/// what the latter come to.
macro_rules! line_method_options {
    ($(#[$meta:meta])* $vis:vis struct $options:ident { $($own:tt)* }) => {
        silhouette_core::method_options! {
            $(#[$meta])*
            $vis struct $options {
                $($own)*
                /// Width of lines.
                pub width: f64 = number("width", 0.0..=1000.0 "in width-unit", default 2.0),
                /// Unit of width: pixels, units of the world at the depth of the line, millimetres of paper, percent of the
                /// image's height.
                pub width_unit: silhouette_core::line_style::WidthUnitChoice = choice("width-unit"),
                /// Resolution of the paper that width-unit=mm means.
                pub dpi: f64 = number("dpi", 1.0..=10000.0 "px/inch", default 300.0),
                /// Red of the ink, in sRGB as displayed.
                pub ink_red: f64 = number("ink-red", 0.0..=1.0, default 0.0),
                /// Green of the ink, in sRGB as displayed.
                pub ink_green: f64 = number("ink-green", 0.0..=1.0, default 0.0),
                /// Blue of the ink, in sRGB as displayed.
                pub ink_blue: f64 = number("ink-blue", 0.0..=1.0, default 0.0),
                /// Opacity of the ink: 0 draws nothing, 1 covers what lies below.
                pub ink_alpha: f64 = number("ink-alpha", 0.0..=1.0, default 1.0),
                /// The mesh: white, depth without colour, or nothing, where the caller's own depth hides lines.
                pub interior: silhouette_core::line_style::InteriorChoice = choice("interior"),
            }
        }

        #[cfg(feature = "gpu")]
        impl $options {
            /// Width, ink and interior.
            pub(crate) fn line_style(&self) -> crate::line_style::LineStyle {
                crate::line_style::LineStyle {
                    width: silhouette_core::line_style::LineWidth {
                        value: self.width,
                        unit: self.width_unit.with_dpi(self.dpi),
                        thins_beyond_radii: None,
                    },
                    ink: silhouette_gpu::Color {
                        srgb: [self.ink_red, self.ink_green, self.ink_blue],
                        alpha: self.ink_alpha,
                    },
                    interior: self.interior,
                }
            }
        }
    };
}
pub(crate) use line_method_options;
