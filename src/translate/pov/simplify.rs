//! Leaves out what is empty, writes equal objects once, and gives all of them names.

use std::collections::HashMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use super::tree::{Body, Declaration, Modifier, Object, Operation, Pattern, Texture, Tree, Uses};
use crate::scene::Geometry;
use crate::scene::geometry::Parameter;

/// The tree without empty objects and duplicates, and with names for its objects and textures.
pub(super) fn simplified<'a>(tree: Tree<'a>) -> Tree<'a> {
    let mut out = Simplified::default();
    for declared in tree.objects {
        let number = out
            .object(declared.object)
            .map(|o| out.number(declared.id, o));
        out.numbers.push(number);
    }
    let root = tree.root.and_then(|root| out.numbers[root]);
    let mut textures = used(&tree.textures, |f| {
        let mut look = |object: &mut Object| {
            for modifier in &mut object.modifiers {
                if let Modifier::Texture(number) | Modifier::InnerTexture(number) = modifier {
                    f(number);
                }
            }
        };
        let objects = out.objects.iter_mut();
        objects.for_each(|declared| declared.object.each(&mut look));
    });
    let images = used(&tree.images, |f| {
        for texture in &mut textures {
            if let Pattern::Image(_, image) = &mut texture.pattern {
                f(image);
            }
        }
    });
    name(&mut textures);
    Tree {
        images,
        textures,
        uses: uses(&mut out.objects),
        objects: out.objects,
        root,
    }
}

#[derive(Default)]
struct Simplified<'a> {
    objects: Vec<Declaration<'a>>,
    /// For each object that was declared, its number in `objects`; `None` for an empty object.
    numbers: Vec<Option<usize>>,
    /// The numbers of objects by the hash of their contents.
    known: HashMap<u64, Vec<usize>>,
    /// How many objects of each entity there are.
    times: HashMap<u32, u32>,
}

impl<'a> Simplified<'a> {
    /// The number of an equal object, if there is one; otherwise the object is added, and has a new number.
    fn number(&mut self, id: u32, object: Object<'a>) -> usize {
        let mut hash = DefaultHasher::new();
        hash_object(&object, &mut hash);
        let alike = self.known.entry(hash.finish()).or_default();
        let is_same = |other: &&usize| {
            let other = &self.objects[**other].object;
            other.body == object.body && other.modifiers == object.modifiers
        };
        if let Some(same) = alike.iter().find(is_same) {
            return *same;
        }
        let times = self.times.entry(id).or_insert(0);
        *times += 1;
        let name = match (id, *times) {
            (0, n) => format!("Part_{n}"),
            (id, 1) => format!("Object_{id}"),
            (id, n) => format!("Object_{id}_{n}"),
        };
        let number = self.objects.len();
        alike.push(number);
        self.objects.push(Declaration { id, name, object });
        number
    }

    /// An object without its empty parts; `None` if nothing is left.
    fn object(&self, object: Object<'a>) -> Option<Object<'a>> {
        let Object {
            body,
            modifiers,
            comment,
        } = object;
        let simple = match body {
            Body::Declared(number) => self.numbers[number].map(|n| Object::new(Body::Declared(n))),
            Body::Operation(operation, operands) => self.operation(operation, operands),
            body => Some(Object::new(body)),
        };
        let mut simple = match simple {
            Some(simple) => simple,
            // Nothing, turned inside out, is all of space.
            None if modifiers.contains(&Modifier::Inverse) => Object::new(Body::Everything),
            None => return None,
        };
        let is_everything = simple.body == Body::Everything;
        for modifier in modifiers {
            simple.modifiers.push(match modifier {
                Modifier::Clip(by) => match self.object(*by)? {
                    by if by.body == Body::Everything && by.modifiers.is_empty() => continue,
                    by => Modifier::inside(by),
                },
                Modifier::Inverse | Modifier::Matrix(_) if is_everything => continue,
                modifier => modifier,
            });
        }
        simple.comment = comment;
        Some(simple)
    }

    /// An operation without its empty operands; `None` if nothing is left. If a single operand is left, it takes the
    /// place of the operation.
    fn operation(&self, operation: Operation, operands: Vec<Object<'a>>) -> Option<Object<'a>> {
        let takes_away = matches!(
            operation,
            Operation::Difference | Operation::CutawayDifference
        );
        let mut left = Vec::with_capacity(operands.len());
        for (i, operand) in operands.into_iter().enumerate() {
            match self.object(operand) {
                Some(operand) => left.push(operand),
                None if operation == Operation::Intersection || (takes_away && i == 0) => {
                    return None;
                }
                None => {}
            }
        }
        (!left.is_empty()).then(|| Object::of(operation, left))
    }
}

/// The items in use, in the order of their first use. `each` calls the function that it is given with every reference
/// to an item, and the function sets the item's new number.
fn used<T: Clone>(all: &[T], each: impl FnOnce(&mut dyn FnMut(&mut usize))) -> Vec<T> {
    let mut used = Vec::new();
    let mut numbers = vec![None; all.len()];
    each(&mut |number| {
        *number = *numbers[*number].get_or_insert_with(|| {
            used.push(all[*number].clone());
            used.len() - 1
        });
    });
    used
}

/// Names each texture after the entity that owns it. Textures of one entity are told apart by numbers.
fn name(textures: &mut [Texture]) {
    let mut times: HashMap<(String, bool), u32> = HashMap::new();
    for texture in textures {
        let name = match texture.owner {
            (0, Some(on)) => format!("Look_{on}"),
            (owner, Some(on)) => format!("Look_{owner}_on_{on}"),
            (owner, None) => format!("Look_{owner}"),
        };
        let times = times.entry((name.clone(), texture.is_behind)).or_insert(0);
        *times += 1;
        let behind = if texture.is_behind { "_Behind" } else { "" };
        texture.name = match *times {
            1 => format!("{name}{behind}"),
            n => format!("{name}_{n}{behind}"),
        };
    }
}

fn uses(objects: &mut [Declaration]) -> Uses {
    let mut uses = Uses::default();
    for declared in objects {
        declared.object.each(&mut |object| {
            match &object.body {
                Body::Everything => uses.everywhere = true,
                Body::Shape(shape) => {
                    if let Geometry::GeodesicSphere { splits, .. } = **shape {
                        uses.splits.insert(splits);
                    }
                }
                Body::Mesh(_) | Body::Declared(_) | Body::Operation(..) => {}
            }
            for modifier in &object.modifiers {
                match modifier {
                    Modifier::Unseen | Modifier::UnseenWithin => uses.unseen = true,
                    Modifier::Index(index) => {
                        uses.refraction |= *index != [1.0; 3];
                        uses.dispersion |= index.iter().any(|i| *i != index[0]);
                    }
                    Modifier::Matrix(_)
                    | Modifier::Texture(_)
                    | Modifier::InnerTexture(_)
                    | Modifier::Inverse
                    | Modifier::Clip(_)
                    | Modifier::Bound(_) => {}
                }
            }
        });
    }
    uses
}

fn hash_object(object: &Object, hash: &mut DefaultHasher) {
    match &object.body {
        Body::Shape(shape) => hash_shape(shape, hash),
        Body::Mesh(triangles) => triangles.iter().for_each(|t| hash_shape(t, hash)),
        Body::Declared(number) => number.hash(hash),
        Body::Everything => {}
        Body::Operation(operation, operands) => {
            operation.hash(hash);
            operands.iter().for_each(|o| hash_object(o, hash));
        }
    }
    for modifier in &object.modifiers {
        match modifier {
            Modifier::Matrix(m) => m.0.iter().flatten().for_each(|x| hash_number(*x, hash)),
            Modifier::Texture(number) | Modifier::InnerTexture(number) => number.hash(hash),
            Modifier::Index(index) => index.iter().for_each(|x| hash_number(*x, hash)),
            Modifier::Clip(by) => hash_object(by, hash),
            Modifier::Unseen | Modifier::UnseenWithin | Modifier::Inverse | Modifier::Bound(_) => {}
        }
    }
}

fn hash_shape(shape: &Geometry, hash: &mut DefaultHasher) {
    for parameter in shape.record().1 {
        match parameter {
            Parameter::Real(x) => hash_number(x, hash),
            Parameter::Integer(n) => n.hash(hash),
        }
    }
}

/// Hashes a number by its bits. Adding zero turns −0 into 0, so that both have the same hash.
fn hash_number(x: f64, hash: &mut DefaultHasher) {
    (x + 0.0).to_bits().hash(hash);
}
