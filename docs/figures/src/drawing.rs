//! SVG, as text.

use std::fmt::Write;

/// A place in a drawing, in pixels from its upper left corner.
pub(crate) type Pixel = [f64; 2];

/// The styles of the classes. The colours are by Okabe and Ito; colour-blind readers can distinguish them.
const STYLE: &str = "\
text{font:13px sans-serif;fill:#222}
.bold{font-weight:bold}.middle{text-anchor:middle}.small{font-size:11.5px}
polyline,path{fill:none;stroke-linejoin:round;stroke-linecap:round;stroke-width:1.5}
.thin{stroke:#999;stroke-width:1}.dashed{stroke-dasharray:5 4}
.black{stroke:#222}.blue{stroke:#0072b2}.orange{stroke:#d55e00}.green{stroke:#009e73}.wide{stroke-width:3}
.halo{stroke:#fff;stroke-width:9}
polygon{stroke-linejoin:round}
.start{fill:#0072b2;fill-opacity:.35}.end{fill:#d55e00;fill-opacity:.35}.now{fill:#f0e442;fill-opacity:.6}
.cell{stroke:#fff;stroke-width:.8}
.cell-start{fill:#0072b2}.cell-end{fill:#d55e00}.side{fill:#56b4e9}
.pair{fill:#e69f00}
.swept{fill:#56b4e9;fill-opacity:.35;stroke:#fff;stroke-width:.6}
.odd{fill:#9ad2f2;stroke:none;fill-rule:evenodd}
.dot{fill:#222}.ring{fill:#fff;stroke:#222;stroke-width:1.5}
.contact{fill:#009e73}.crossing{fill:#fff;stroke:#009e73;stroke-width:2}.covered{fill:#d55e00}
";

/// A drawing on a white ground.
pub(crate) struct Drawing {
    svg: String,
}

impl Drawing {
    pub(crate) fn new(title: &str, [width, height]: [u32; 2]) -> Self {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\">\n<title>{title}</title>\n<style>\n{STYLE}</style>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
        );
        Self { svg }
    }

    pub(crate) fn line(&mut self, class: &str, points: &[Pixel]) {
        self.element("polyline", class, &format!("points=\"{}\"", list(points)));
    }

    pub(crate) fn area(&mut self, class: &str, points: &[Pixel]) {
        self.element("polygon", class, &format!("points=\"{}\"", list(points)));
    }

    /// A cell of a surface, with an opacity from 0 to 1.
    pub(crate) fn shaded(&mut self, class: &str, opacity: f64, points: &[Pixel]) {
        let points = list(points);
        self.element(
            "polygon",
            &format!("cell {class}"),
            &format!("fill-opacity=\"{opacity:.2}\" points=\"{points}\""),
        );
    }

    /// Two triangles as one area.
    pub(crate) fn areas(&mut self, class: &str, triangles: &[[Pixel; 3]; 2]) {
        let outlines = triangles.each_ref().map(|points| format!("M{}Z", list(points)));
        self.element("path", class, &format!("d=\"{}\"", outlines.concat()));
    }

    pub(crate) fn dot(&mut self, class: &str, place: Pixel) {
        let [x, y] = place.map(rounded);
        self.element("circle", class, &format!("cx=\"{x}\" cy=\"{y}\" r=\"4\""));
    }

    pub(crate) fn text(&mut self, class: &str, place: Pixel, text: &str) {
        let [x, y] = place.map(rounded);
        let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('-', "−");
        self.push(&format!(
            "<text class=\"{class}\" x=\"{x}\" y=\"{y}\">{text}</text>"
        ));
    }

    /// A line with a head at its end.
    pub(crate) fn arrow(&mut self, class: &str, from: Pixel, to: Pixel) {
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
        let [x, y] = along.map(|c| c / length);
        let barb = |side: f64| [to[0] - 7.0 * x - side * 4.0 * y, to[1] - 7.0 * y + side * 4.0 * x];
        self.line(class, &[from, to]);
        self.line(class, &[barb(1.0), to, barb(-1.0)]);
    }

    pub(crate) fn finish(mut self) -> String {
        self.push("</svg>");
        self.svg
    }

    fn element(&mut self, name: &str, class: &str, attributes: &str) {
        self.push(&format!("<{name} class=\"{class}\" {attributes}/>"));
    }

    fn push(&mut self, line: &str) {
        writeln!(self.svg, "{line}").expect("a string takes all");
    }
}

fn list(points: &[Pixel]) -> String {
    let pair = |point: &Pixel| {
        let [x, y] = point.map(rounded);
        format!("{x},{y}")
    };
    points.iter().map(pair).collect::<Vec<_>>().join(" ")
}

/// In tenths of a pixel, and without −0.
fn rounded(x: f64) -> f64 {
    (x * 10.0).round() / 10.0 + 0.0
}
