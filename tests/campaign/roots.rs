//! The real roots of polynomials with exact coefficients: how many, and where.

use super::exact::Exact;
use dashu_int::IBig;

/// A root of at² + 2bt + c, between bounds that can be made as narrow as one likes.
#[derive(Debug, Clone)]
pub struct Root {
    a: Exact,
    b: Exact,
    c: Exact,
    /// Whether the discriminant's root is added; of no meaning where a is zero.
    plus: bool,
    pub low: Exact,
    pub high: Exact,
}

/// Digits to begin with.
const FIRST: i64 = 128;

/// Two roots of quadratics with coefficients of up to b digits each are roots of a quartic with
/// coefficients of about 4b digits, and if they differ, then by more than 2⁻⁸ᵇ of the larger one or
/// so (Mahler's bound). The b met here are below 1000, most of them below 400.
const LAST: i64 = 8192;

impl Root {
    /// The roots of at² + 2bt + c, a double one once; none if all t are.
    pub fn quadratic(a: Exact, b: Exact, c: Exact) -> Vec<Root> {
        let one = |plus| {
            let mut root = Root {
                a: a.clone(),
                b: b.clone(),
                c: c.clone(),
                plus,
                low: Exact::zero(),
                high: Exact::zero(),
            };
            root.refine(FIRST);
            root
        };
        if a.is_zero() {
            return if b.is_zero() { vec![] } else { vec![one(true)] };
        }
        match discriminant(&a, &b, &c).sign() {
            -1 => vec![],
            0 => vec![one(true)],
            _ => vec![one(false), one(true)],
        }
    }

    /// Aabb from so many digits.
    fn refine(&mut self, digits: i64) {
        (self.low, self.high) = if self.a.is_zero() {
            (-&self.c).over(&self.b.twice(), digits)
        } else {
            let (low, high) = discriminant(&self.a, &self.b, &self.c).root(digits);
            let (low, high) = if self.plus {
                (low - &self.b, high - &self.b)
            } else {
                (-&self.b - high, -&self.b - low)
            };
            let (p, q) = (low.over(&self.a, digits), high.over(&self.a, digits));
            if self.a.is_positive() {
                (p.0, q.1)
            } else {
                (q.0, p.1)
            }
        };
    }
}

fn discriminant(a: &Exact, b: &Exact, c: &Exact) -> Exact {
    b.square() - a * c
}

/// The roots in ascending order, equal ones once, with bounds that do not overlap.
pub fn sorted(mut roots: Vec<Root>) -> Vec<Root> {
    let mut digits = FIRST;
    loop {
        roots.sort_by(|a, b| a.low.cmp(&b.low));
        let close: Vec<usize> = (1..roots.len())
            .filter(|&i| roots[i].low <= roots[i - 1].high)
            .collect();
        if close.is_empty() {
            return roots;
        }
        // Aabb that are exact numbers, or as narrow as all that differ.
        let same = |a: &Root, b: &Root| {
            let point = |r: &Root| r.low == r.high;
            digits >= LAST || point(a) && point(b)
        };
        let equal: Vec<usize> = (close.iter().copied())
            .filter(|&i| same(&roots[i - 1], &roots[i]))
            .collect();
        for &i in equal.iter().rev() {
            roots.remove(i);
        }
        if equal.is_empty() {
            digits *= 8;
            for i in close {
                roots[i - 1].refine(digits);
                roots[i].refine(digits);
            }
        }
    }
}

/// A number of few digits between two others.
pub fn between(low: &Exact, high: &Exact) -> Exact {
    let mut exponent = (high - low).top() - 1;
    let units = |x: &Exact, exponent: i64| {
        if x.exponent >= exponent {
            x.mantissa_at(exponent)
        } else {
            // Towards minus infinity.
            &x.mantissa >> (exponent - x.exponent) as usize
        }
    };
    loop {
        let mantissa = units(low, exponent) + IBig::from(1);
        let between = Exact { mantissa, exponent };
        if low < &between && &between < high {
            return between;
        }
        exponent -= 1;
    }
}

/// How many real roots of odd multiplicity a polynomial has, which is how often it changes sign;
/// coefficients from the constant on.
pub fn sign_changes(coefficients: &[Exact]) -> usize {
    let exponent = coefficients.iter().map(|c| c.exponent).min().unwrap_or(0);
    let mut f = coefficients
        .iter()
        .map(|c| c.mantissa_at(exponent))
        .collect();
    trim(&mut f);
    // With Nₖ the number of different roots of multiplicity k or more, N₁ − N₂ + N₃ − N₄: those of
    // f, of the greatest common divisor of f and f′, of that one's with its derivative, …
    let (mut sum, mut sign) = (0isize, 1);
    while f.len() > 1 {
        let (different, divisor) = sturm(f);
        sum += sign * different as isize;
        sign = -sign;
        f = divisor;
    }
    sum as usize
}

fn trim(f: &mut Vec<IBig>) {
    while f.last().is_some_and(IBig::is_zero) {
        f.pop();
    }
}

fn is_negative(x: &IBig) -> bool {
    !x.is_zero() && x.sign() == dashu_int::Sign::Negative
}

/// The number of different real roots by Sturm's theorem, and the greatest common divisor of the
/// polynomial and its derivative.
fn sturm(f: Vec<IBig>) -> (usize, Vec<IBig>) {
    let derivative: Vec<IBig> = (f.iter().enumerate().skip(1))
        .map(|(i, c)| c * IBig::from(i))
        .collect();
    let mut chain = vec![f, derivative];
    loop {
        let n = chain.len();
        let mut rest = remainder(&chain[n - 2], &chain[n - 1]);
        if rest.is_empty() {
            break;
        }
        // In a regular chain the square of the leading coefficient two before divides what is left
        // (Collins, "Subresultants and reduced polynomial remainder sequences", 1967).
        if n > 2 && chain.windows(2).all(|w| w[0].len() == w[1].len() + 1) {
            let leading = chain[n - 2].last().expect("trimmed").clone();
            let square = &leading * &leading;
            for c in &mut rest {
                *c = &*c / &square;
            }
        }
        for c in &mut rest {
            *c = -&*c;
        }
        chain.push(rest);
    }
    let changes = |at_minus: bool| {
        let negative = |f: &Vec<IBig>| {
            let odd = f.len().is_multiple_of(2);
            is_negative(f.last().expect("trimmed")) != (at_minus && odd)
        };
        chain
            .windows(2)
            .filter(|w| negative(&w[0]) != negative(&w[1]))
            .count()
    };
    let different = changes(true) - changes(false);
    (different, chain.pop().unwrap_or_default())
}

/// The remainder of f by g times a positive number, which is an even power of g's leading
/// coefficient.
fn remainder(f: &[IBig], g: &[IBig]) -> Vec<IBig> {
    let leading = g.last().expect("trimmed");
    let mut rest = f.to_vec();
    let mut times = 0;
    while rest.len() >= g.len() {
        let shift = rest.len() - g.len();
        let top = rest.pop().expect("not shorter than g");
        for c in &mut rest {
            *c = &*c * leading;
        }
        for (i, c) in g[..g.len() - 1].iter().enumerate() {
            rest[shift + i] -= &top * c;
        }
        times += 1;
    }
    if times % 2 == 1 {
        for c in &mut rest {
            *c = &*c * leading;
        }
    }
    trim(&mut rest);
    rest
}
