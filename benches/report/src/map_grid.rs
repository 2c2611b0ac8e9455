//! Maps of errors over two inputs: panels of cells, measured on all cores and kept as CSV. All points follow from the grid
//! and a seed; no clock.

mod table;

pub use table::{difference, read, write};

use reference::generate::random::Random;
use reference::registry::{Call, Method, Precision, methods};

/// Value of a cell with a result that is not finite.
pub const NOT_FINITE: f64 = 99.0;
/// Columns and rows of a panel.
pub const CELLS: [usize; 2] = [48, 64];
/// Random points measured in each cell beside its centre.
const POINTS: u64 = 3;
/// A place in a panel, in parts of 1, and the inputs there.
pub type Place = ([f64; 2], Vec<f64>);

/// Points for the share of a panel without a digit.
const SPREAD: usize = 2000;
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// Place of point `i` of a lattice with this step: 1 for even spacing.
fn part_of(i: usize, step: f64) -> f64 {
    if step == 1.0 {
        (i as f64 + 0.5) / SPREAD as f64
    } else {
        (i as f64 * step).fract()
    }
}

/// One map.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Its place in the figure.
    pub number: usize,
    /// Cells, row by row from the bottom.
    pub cells: Vec<f64>,
    /// Part of the panel, in per cent, on which the result is worthless; from points of its own.
    pub hopeless: f64,
}

impl Panel {
    /// The largest value that is not [`NOT_FINITE`].
    pub fn most(&self) -> f64 {
        let finite = self.cells.iter().filter(|c| **c < NOT_FINITE);
        finite.copied().fold(0.0, f64::max)
    }
}

/// The points of a cell within it, in parts of 1: the centre, then random ones.
fn points_of_cell(index: usize) -> impl Iterator<Item = [f64; 2]> {
    let mut random = Random::new(index as u64);
    let others = (0..POINTS).map(move |_| [0; 2].map(|_| random.uniform(0.0, 1.0)));
    std::iter::once([0.5; 2]).chain(others)
}

/// The cell that holds a place of a panel.
pub(crate) fn cell_of([x, y]: [f64; 2]) -> usize {
    let index = |part: f64, count: usize| ((part * count as f64) as usize).min(count - 1);
    index(y, CELLS[1]) * CELLS[0] + index(x, CELLS[0])
}

/// What is measured at the places of a figure's panels.
pub(crate) struct Measured<S, R, M> {
    /// The value of a call at a row of inputs.
    pub score: S,
    /// The inputs of a panel at a place of it, in parts of 1.
    pub row: R,
    /// The places where a panel is measured besides.
    pub more: M,
    /// The value from which a result of this precision is worthless.
    pub worthless: fn(Precision) -> f64,
}

impl<S, R, M> Measured<S, R, M>
where
    S: Fn(&Call, &[f64]) -> f64 + Sync,
    R: Fn(usize, [f64; 2]) -> Vec<f64> + Sync,
    M: Fn(usize) -> Vec<Place> + Sync,
{
    /// Measures panels on all cores: `calls` by panel.
    pub fn panels(&self, calls: &[(usize, Call)]) -> Vec<Panel> {
        calls.iter().map(|(number, call)| self.panel(*number, call)).collect()
    }

    fn cell(&self, panel: usize, call: &Call, index: usize) -> f64 {
        let [columns, rows] = CELLS;
        let values = points_of_cell(index).map(|[s, t]| {
            let x = ((index % columns) as f64 + s) / columns as f64;
            let y = ((index / columns) as f64 + t) / rows as f64;
            (self.score)(call, &(self.row)(panel, [x, y]))
        });
        values.fold(f64::NAN, f64::max)
    }

    fn panel(&self, number: usize, call: &Call) -> Panel {
        let count = CELLS[0] * CELLS[1];
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let share = count.div_ceil(threads);
        let mut cells = vec![f64::NAN; count];
        std::thread::scope(|scope| {
            for (part, slot) in cells.chunks_mut(share).enumerate() {
                scope.spawn(move || {
                    for (k, value) in slot.iter_mut().enumerate() {
                        *value = self.cell(number, call, part * share + k);
                    }
                });
            }
        });
        for (place, row) in (self.more)(number) {
            let worst = &mut cells[cell_of(place)];
            *worst = worst.max((self.score)(call, &row));
        }
        // An additive lattice: even in both directions.
        let spread = (0..SPREAD).map(|i| (self.row)(number, [1.0, GOLDEN].map(|step| part_of(i, step))));
        let worthless = (self.worthless)(call.precision());
        let gone = spread.filter(|row| (self.score)(call, row) >= worthless).count();
        Panel {
            number,
            cells,
            hopeless: 100.0 * gone as f64 / SPREAD as f64,
        }
    }
}

/// The scalar method of a name, if it is registered.
pub(crate) fn scalar(function: &str, method: &str, precision: Precision) -> Option<&'static Method> {
    let named = |m: &&Method| m.function == function && m.method == method && m.precision == precision;
    methods().iter().filter(named).find(|m| !m.call.is_slice())
}
