//! Polynomials with rational coefficients and their real roots, without any rounding.

use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use std::cmp::Ordering;
use std::rc::Rc;

pub type Q = RBig;

/// A finite double as the rational number it is.
pub fn q(x: f64) -> Q {
    Q::try_from(x).unwrap()
}

/// The nearest double.
pub fn to_f64(x: &Q) -> f64 {
    x.to_f64().value()
}

pub fn sign(x: &Q) -> i32 {
    x.cmp(&Q::ZERO) as i32
}

/// c₀ + c₁t + …; the last coefficient is not zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Poly(Vec<Q>);

impl Poly {
    pub fn new(mut c: Vec<Q>) -> Poly {
        while c.last().is_some_and(Q::is_zero) {
            c.pop();
        }
        Poly(c)
    }

    /// Zero everywhere.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The same with whole coefficients, times a positive number: for signs that is as good, and
    /// nothing has to be reduced to lowest terms.
    pub fn whole(&self) -> Whole {
        let mut factor = UBig::ONE;
        for c in &self.0 {
            let scaled = c * Q::from(factor.clone());
            factor *= scaled.denominator();
        }
        let factor = Q::from(factor);
        let whole = |c: &Q| (c * &factor).numerator().clone();
        Whole(self.0.iter().map(whole).collect())
    }

    pub fn plus(&self, other: &Poly, factor: &Q) -> Poly {
        let n = self.0.len().max(other.0.len());
        let of = |p: &Poly, i: usize| p.0.get(i).cloned().unwrap_or(Q::ZERO);
        Poly::new(
            (0..n)
                .map(|i| of(self, i) + of(other, i) * factor)
                .collect(),
        )
    }

    pub fn times(&self, other: &Poly) -> Poly {
        let mut c = vec![Q::ZERO; (self.0.len() + other.0.len()).max(1) - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                c[i + j] += a * b;
            }
        }
        Poly::new(c)
    }

    fn derivative(&self) -> Poly {
        let terms = self.0.iter().enumerate().skip(1);
        Poly::new(terms.map(|(i, c)| c * Q::from(i as u32)).collect())
    }

    /// Quotient and remainder.
    fn divide(&self, by: &Poly) -> (Poly, Poly) {
        let lead = by.0.last().unwrap();
        let mut rest = self.0.clone();
        let mut quotient = Vec::new();
        while rest.len() >= by.0.len() {
            let factor = rest.last().unwrap() / lead;
            let low = rest.len() - by.0.len();
            for (i, c) in by.0.iter().enumerate() {
                rest[low + i] -= &factor * c;
            }
            rest.pop();
            quotient.push(factor);
        }
        quotient.reverse();
        (Poly::new(quotient), Poly::new(rest))
    }

    fn gcd(&self, other: &Poly) -> Poly {
        let (mut a, mut b) = (self.clone(), other.clone());
        while !b.is_zero() {
            (a, b) = (b.clone(), a.divide(&b).1);
        }
        a
    }

    /// The same roots, each once.
    fn simple(&self) -> Poly {
        self.divide(&self.gcd(&self.derivative())).0
    }

    /// Sturm's chain of a polynomial without multiple roots.
    fn chain(&self) -> Vec<Whole> {
        let mut chain = vec![self.clone(), self.derivative()];
        while !chain.last().unwrap().is_zero() {
            let n = chain.len();
            let rest = chain[n - 2].divide(&chain[n - 1]).1;
            chain.push(Poly(rest.0.into_iter().map(|c| -c).collect()));
        }
        chain.pop();
        chain.iter().map(Poly::whole).collect()
    }

    /// All real roots, ascending, each once; none of the zero polynomial.
    pub fn roots(&self) -> Vec<Root> {
        if self.0.len() < 2 {
            return Vec::new();
        }
        let poly = Rc::new(self.simple());
        let whole = Rc::new(poly.whole());
        let chain = poly.chain();
        // Cauchy's bound.
        let lead = poly.0.last().unwrap();
        let size = |c: Q| if sign(&c) < 0 { -c } else { c };
        let bound = poly.0.iter().map(|c| size(c / lead)).max().unwrap() + Q::ONE;
        let mut open = vec![(-&bound, bound)];
        let mut roots = Vec::new();
        while let Some((low, high)) = open.pop() {
            match count(&chain, &low, &high) {
                0 => {}
                1 => roots.push(Root {
                    poly: poly.clone(),
                    whole: whole.clone(),
                    low,
                    high,
                }),
                _ => {
                    let middle = (&low + &high) / Q::from(2u32);
                    open.push((middle.clone(), high));
                    open.push((low, middle));
                }
            }
        }
        roots
    }
}

/// How many roots the first polynomial of a Sturm chain has in (low, high].
fn count(chain: &[Whole], low: &Q, high: &Q) -> usize {
    let changes = |t: &Q| {
        let signs = chain.iter().map(|p| p.sign(t)).filter(|&s| s != 0);
        let signs: Vec<i32> = signs.collect();
        signs.windows(2).filter(|w| w[0] != w[1]).count()
    };
    changes(low) - changes(high)
}

/// A polynomial with whole coefficients.
#[derive(Debug)]
pub struct Whole(Vec<IBig>);

impl Whole {
    /// The sign at n/d, which is that of Σ cᵢ nⁱ d^(degree − i).
    pub fn sign(&self, t: &Q) -> i32 {
        let (n, d) = (t.numerator(), IBig::from(t.denominator().clone()));
        let mut sum = IBig::ZERO;
        let mut power = IBig::ONE;
        for c in self.0.iter().rev() {
            sum = sum * n + c * &power;
            power *= &d;
        }
        sum.cmp(&IBig::ZERO) as i32
    }
}

/// A real root of a polynomial: the only one in (low, high].
#[derive(Debug, Clone)]
pub struct Root {
    poly: Rc<Poly>,
    whole: Rc<Whole>,
    pub low: Q,
    pub high: Q,
}

impl Root {
    /// A rational number.
    pub fn rational(x: Q) -> Root {
        Root {
            whole: Rc::new(Poly(vec![-&x, Q::ONE]).whole()),
            poly: Rc::new(Poly(vec![-&x, Q::ONE])),
            low: &x - Q::ONE,
            high: x,
        }
    }

    /// Halves the interval.
    pub fn refine(&mut self) {
        let at_high = self.whole.sign(&self.high);
        if at_high == 0 {
            self.low = (&self.low + &self.high) / Q::from(2u32);
            return;
        }
        let middle = (&self.low + &self.high) / Q::from(2u32);
        if self.whole.sign(&middle) * at_high < 0 {
            self.low = middle;
        } else {
            self.high = middle;
        }
    }

    /// A rational number at most 2⁻ᵇⁱᵗˢ away.
    pub fn near(&mut self, bits: usize) -> Q {
        let width = Q::from_parts(1.into(), UBig::ONE << bits);
        while &self.high - &self.low > width {
            self.refine();
        }
        self.high.clone()
    }

    /// Which of two roots is greater; decides also whether they are equal.
    pub fn compare(&mut self, other: &mut Root) -> Ordering {
        // Most are told apart by a few bits; only others need a common divisor.
        for bits in 0.. {
            if self.high <= other.low {
                return Ordering::Less;
            }
            if other.high <= self.low {
                return Ordering::Greater;
            }
            if bits == 24 {
                // A common root where both have just one is that one.
                let common = self.poly.gcd(&other.poly);
                let (low, high) = ((&self.low).max(&other.low), (&self.high).min(&other.high));
                if common.0.len() > 1 && count(&common.chain(), low, high) > 0 {
                    return Ordering::Equal;
                }
            }
            self.refine();
            other.refine();
        }
        unreachable!("an endless loop has ended")
    }
}

#[test]
fn roots_of_known_polynomials() {
    let from = |list: &[i32]| {
        list.iter().fold(Poly::new(vec![Q::ONE]), |p, &r| {
            p.times(&Poly::new(vec![Q::from(-r), Q::ONE]))
        })
    };
    let near =
        |p: &Poly| -> Vec<f64> { p.roots().iter_mut().map(|r| to_f64(&r.near(80))).collect() };
    // Each once, however often; none of t² + 1; ±√2.
    assert_eq!(near(&from(&[2, 1, -3, 1])), [-3.0, 1.0, 2.0]);
    assert_eq!(near(&from(&[5, 5, 5, 5])), [5.0]);
    let square = |c: i32| Poly::new(vec![Q::from(c), Q::ZERO, Q::ONE]);
    assert!(near(&square(1)).is_empty());
    let root = std::f64::consts::SQRT_2;
    assert_eq!(near(&square(-2).times(&square(1))), [-root, root]);
    // Equal roots of different polynomials are equal, near ones are not.
    let mut a = square(-2).roots().remove(1);
    let mut b = square(-2).times(&from(&[7])).roots().remove(1);
    assert_eq!(a.compare(&mut b), Ordering::Equal);
    let mut c = Root::rational(q(root));
    assert_eq!(a.compare(&mut c), Ordering::Less);
    assert_eq!(c.compare(&mut a), Ordering::Greater);
    assert_eq!(c.compare(&mut Root::rational(q(root))), Ordering::Equal);
}
