//! Cuts that are flush, and cuts that nearly are.

use crate::lint::testing::found;

#[test]
fn many_holes_are_found_in_a_chain() {
    let mut scene = String::from("2 12 0 0 0 1000 1 1000\n");
    let mut id = 2;
    for i in 0..500 {
        let (x, z) = (i % 25 * 30 + 10, i / 25 * 30 + 10);
        let top = if i == 250 { "1" } else { "2" };
        let (tool, next) = (id + 1, id + 2);
        scene += &format!(
            "{tool} 12 {x} -1 {z} {} {top} {}\n{next} -103 {id} {tool}\n",
            x + 5,
            z + 5
        );
        id = next;
    }
    assert_eq!(found(&scene).len(), 1);
}

#[test]
fn long_chains_and_shared_parts_end() {
    // A plate with ten thousand flush holes, and a difference of copies of copies.
    let mut plate = String::from("2 12 0 0 0 1e6 1 1e6\n");
    for i in 0..10_000 {
        let (tool, next, last) = (2 * i + 3, 2 * i + 4, 2 * i + 2);
        let (x, z) = (i % 100 * 30 + 10, i / 100 * 30 + 10);
        plate += &format!(
            "{tool} 12 {x} 0.5 {z} {} 1 {}\n{next} -103 {last} {tool}\n",
            x + 5,
            z + 5
        );
    }
    let mut copies = String::from("2 12 0 0 0 1 1 1\n");
    for i in 2..60 {
        let (copy, sum) = (2 * i + 100, 2 * i + 101);
        let of = if i == 2 { 2 } else { 2 * i + 99 };
        copies += &format!("{copy} -105 {of}\n{copy} -1 0 1 0\n{sum} -103 {of} {copy}\n");
    }
    for scene in [plate, copies] {
        // A second in a release build; this is for what never ends.
        found(&scene);
    }
}

#[test]
fn every_tool_of_many_is_found() {
    const COUNT: usize = 10_000;
    let tool = |id: usize, i: usize, deep: &str| {
        let (x, z) = (i % 100 * 30 + 10, i / 100 * 30 + 10);
        format!("{id} 12 {x} {deep} {z} {} 1 {}\n", x + 5, z + 5)
    };
    // One after the other, and in one union.
    let mut chain = String::from("2 12 0 0 0 1e4 1 1e4\n");
    let mut union = chain.clone();
    for i in 0..COUNT {
        let (id, sum, last) = (2 * i + 3, 2 * i + 4, 2 * i + 2);
        chain += &format!("{}{sum} -103 {last} {id}\n", tool(id, i, "0.5"));
        union += &tool(id, i, "0.5");
        if i > 0 {
            let last = if i == 1 { 3 } else { last };
            union += &format!("{sum} -101 {last} {id}\n");
        }
    }
    union += &format!("{} -103 2 {}\n", 2 * COUNT + 10, 2 * COUNT + 2);
    for scene in [chain, union] {
        assert_eq!(found(&scene).len(), COUNT);
    }
}
