//! From the text of a scene to its entries.

use exact_ccd_mesh::Point;
use exact_ccd_sim::{HalfSpace, Length, SolidMaterial};

use super::file::{File, Obstacle, Script, TOLERANCE};
use super::shape;
use super::words::{Line, Text};
use crate::fault::{Fault, Problem};
use crate::notes::Notes;

/// A number of friction lags at which they have converged.
const CONVERGED: usize = 100;

/// Keywords that do not change the motion, with blanks between them, and the reason.
const IGNORED: [(&str, &str); 5] = [
    (
        "view zoom cameraTracking playBackSpeed appendStr disableCout",
        "it concerns the viewing and the output of IPC",
    ),
    (
        "warmStart linearSolver linSysSolver",
        "it concerns the method by which IPC solves a time step",
    ),
    (
        "CCDMethod ccdMethod CCDTolerance ccdTolerance",
        "contact is decided exactly; `settings.ccd` selects another method",
    ),
    (
        "kappaMinMultiplier minBarrierStiffnessScale",
        "the stiffness of the barrier is chosen automatically",
    ),
    (
        "constraintType QPSolver constraintOffset useActiveSetConvergence noActiveSetConvergence",
        "it concerns other solvers of IPC than the interior point",
    ),
];

/// Keywords of entries that have further lines.
const SPANNING: [&str; 5] = ["shapes", "shapeMatrix", "section", "tuning", "tol"];

impl File {
    /// The entries of a text.
    pub(super) fn parse(text: &str, notes: &Notes) -> Result<Self, Fault> {
        let mut file = Self::default();
        let mut text = Text::new(text);
        while let Some(mut line) = text.line() {
            match file.entry(&mut line, &mut text, notes) {
                Ok(()) => line.note_rest(notes),
                // The lines that belong to the entry are not known.
                Err(fault) if line.place().has_keyword(&SPANNING) => return Err(fault),
                Err(fault) => notes.fail(fault),
            }
        }
        Ok(file)
    }

    /// Reads an entry; its keyword is the next word of the line.
    fn entry(&mut self, line: &mut Line<'_>, text: &mut Text<'_>, notes: &Notes) -> Result<(), Fault> {
        let settings = &mut self.settings;
        let Some(keyword) = line.keyword() else {
            return Ok(());
        };
        match keyword {
            "shape" => self.shapes.push(shape::one(line)?),
            "shapes" => self.shapes.extend(shape::several(line, text)?),
            "shapeMatrix" => self.shapes.extend(shape::matrix(line, text)?),
            "script" => self.script = script(line)?,
            "size" => {
                let size = line.number("a length in m")?;
                self.size = (size > 0.0).then(|| (line.place().clone(), size));
            }
            "handleRatio" => self.handle_ratio = line.number("a number between 0 and 0.5")?,
            "density" => self.material.density = line.number("a density in kg/m³")?,
            "stiffness" => {
                let expected = "Young's modulus and Poisson's ratio";
                [self.material.young, self.material.poisson] = line.numbers(expected)?;
            }
            "time" => {
                let expected = "the duration and the time step in s";
                [self.duration, settings.time_step] = line.numbers(expected)?;
            }
            "turnOffGravity" => settings.gravity = [0.0; 3],
            "dampingStiff" => self.damping_stiffness = line.number("a number in s³")?.max(0.0),
            "dampingRatio" => self.damping_ratio = line.number("a number")?.clamp(0.0, 1.0),
            "energy" => {
                self.material.energy = match line.word("a name")? {
                    "NH" => SolidMaterial::NeoHookean,
                    "FCR" => SolidMaterial::FixedCorotated,
                    _ => {
                        return Err(
                            line.unsupported("this elastic energy", "write `energy NH` or `energy FCR`")
                        );
                    }
                }
            }
            "timeIntegration" | "constraintSolver" => only(keyword, line)?,
            "section" => skip_section(line, text)?,
            "ground" => {
                let [friction, height] = line.numbers("the friction coefficient and the height")?;
                self.plane([0.0, height, 0.0], [0.0, 1.0, 0.0], friction);
            }
            "halfSpace" => {
                let (point, normal) = (line.numbers("a point")?, line.numbers("a normal")?);
                let [_, friction] = line.numbers("an unused number and the friction coefficient")?;
                self.plane(point, normal, friction);
            }
            "meshCO" => self.obstacles.push(obstacle(line)?),
            "selfCollisionOn" => {}
            "selfCollisionOff" => {
                return Err(line.unsupported("meshes that pass through each other", "remove the line"));
            }
            "selfFric" => {
                settings.friction.coefficient = line.number("a friction coefficient")?.max(0.0);
            }
            "dHat" => settings.contact_distance = Length::Relative(line.number("a length")?),
            "epsv" => {
                settings.friction.static_velocity = Length::Relative(line.number("a velocity")?);
            }
            "useAbsParameters" => self.is_absolute = true,
            "tuning" => self.tuning(line, text)?,
            "tol" => settings.tolerance = Length::Relative(tolerance(line, text)?),
            "fricIterAmt" => {
                let word = line.word("a number of lags")?;
                let lags: i32 = word.parse().map_err(|_| line.invalid(word, "an integer"))?;
                // 0 and less stand for convergence.
                settings.friction.lags = usize::try_from(lags)
                    .ok()
                    .filter(|&lags| lags > 0)
                    .unwrap_or(CONVERGED);
            }
            "DBCTimeRange" => self.dirichlet_times = line.numbers("two times in s")?,
            "NBCTimeRange" => self.neumann_times = line.numbers("two times in s")?,
            "rotateModel" => {
                let instead = "turn the shapes by their angles, as IPC recommends";
                return Err(line.unsupported("a rotation of all shapes against their rest shape", instead));
            }
            "restart" => {
                let instead = "remove the line; `--resume` continues a run of this program";
                return Err(line.unsupported("a state of IPC", instead));
            }
            _ => ignored(keyword, line, notes)?,
        }
        Ok(())
    }

    fn plane(&mut self, point: Point, normal: Point, friction: f64) {
        self.planes.push((HalfSpace::new(point, normal), friction));
    }

    /// The stiffness of the barrier, twice the contact distance, an unused number, and twice the static
    /// velocity: at the start and at the end of a continuation.
    fn tuning(&mut self, line: &mut Line<'_>, text: &mut Text<'_>) -> Result<(), Fault> {
        let numbers = text.numbers(line)?;
        let place = line.place();
        if numbers.first().is_some_and(|&stiffness| stiffness != 0.0) {
            let instead = "write 0 as the first number: the stiffness is chosen automatically";
            return Err(Problem::unsupported("a fixed stiffness of the barrier", instead).at(place));
        }
        let settings = &mut self.settings;
        let lengths = [
            &mut settings.contact_distance,
            &mut settings.friction.static_velocity,
        ];
        for (first, target) in [1, 4].into_iter().zip(lengths) {
            let Some(&start) = numbers.get(first) else {
                continue;
            };
            if numbers.get(first + 1).is_some_and(|&end| end != start) {
                let instead = "write the smaller number twice";
                return Err(
                    Problem::unsupported("a continuation from one distance to another", instead).at(place),
                );
            }
            *target = Length::Relative(start);
        }
        Ok(())
    }
}

/// An entry that does not change the motion.
fn ignored(keyword: &str, line: &mut Line<'_>, notes: &Notes) -> Result<(), Fault> {
    let is_one = |(keywords, _): &&(&str, &str)| keywords.split(' ').any(|other| other == keyword);
    let Some((_, reason)) = IGNORED.iter().find(is_one) else {
        return Err(Problem::Unknown { program: "IPC" }.at(line.place()));
    };
    line.clear();
    notes.add(line.place().clone(), format!("ignored: {reason}"));
    Ok(())
}

/// Checks that the next word is the one that has a counterpart.
fn only(keyword: &str, line: &mut Line<'_>) -> Result<(), Fault> {
    let (allowed, what) = match keyword {
        "timeIntegration" => ("BE", "another time integration than implicit Euler (`BE`)"),
        _ => ("interiorPoint", "another treatment of contact than by barriers"),
    };
    let word = line.word("a name")?;
    if word == allowed || (word, allowed) == ("IP", "interiorPoint") {
        Ok(())
    } else {
        Err(line.unsupported(what, &format!("write `{keyword} {allowed}`")))
    }
}

/// Skips the lines up to `section end` or to the end of the file, unless they are for the interior point.
fn skip_section(line: &mut Line<'_>, text: &mut Text<'_>) -> Result<(), Fault> {
    let mut is_ours = false;
    while !line.is_empty() {
        is_ours |= matches!(line.word("")?, "end" | "interiorPoint" | "IP");
    }
    while !is_ours && let Some(mut next) = text.line() {
        is_ours = next.keyword() == Some("section") && next.word("").is_ok_and(|word| word == "end");
    }
    Ok(())
}

/// The tolerance of all time steps. A line lists tolerances for the first time steps, and the last one counts
/// for all others: different ones are an error.
fn tolerance(line: &mut Line<'_>, text: &mut Text<'_>) -> Result<f64, Fault> {
    let numbers = text.numbers(line)?;
    let Some(&last) = numbers.last() else {
        return Ok(TOLERANCE);
    };
    if numbers.iter().any(|&tolerance| tolerance != last) {
        let instead = "write one tolerance";
        return Err(line.unsupported("a tolerance for each time step", instead));
    }
    Ok(last)
}

fn obstacle(line: &mut Line<'_>) -> Result<Obstacle, Fault> {
    let place = line.place().clone();
    let mesh = line.word("a mesh file")?.to_owned();
    let origin = line.numbers("an origin")?;
    let [scale, _, friction] = line.numbers("a scale, an unused number, and the friction coefficient")?;
    let degrees = match line.keyword() {
        None => [0.0; 3],
        Some("rotate") => line.numbers("three angles in degrees")?,
        Some(word) => return Err(line.invalid(word, "`rotate` or the end of the line")),
    };
    Ok(Obstacle {
        place,
        mesh,
        origin,
        scale,
        degrees,
        friction,
    })
}

fn script(line: &mut Line<'_>) -> Result<Script, Fault> {
    Ok(match line.word("the name of a script")? {
        "null" => Script::Null,
        "fall" => Script::Fall,
        "fallNoShift" => Script::FallNoShift,
        "twist" => Script::Twist,
        "DCOFix" => Script::HeldSurfaces,
        "DCOBallHitWall" => {
            let count = line.optional().unwrap_or(0.0);
            let velocity = if count > 0.0 {
                line.number("a velocity")?
            } else {
                1000.0
            };
            Script::BallHitsWall(velocity)
        }
        name => {
            let what = format!("the script `{name}`");
            let instead =
                "write `script null`, and move the shapes by `linearVelocity`, `angularVelocity` or `DBC`";
            return Err(line.unsupported(&what, instead));
        }
    })
}
