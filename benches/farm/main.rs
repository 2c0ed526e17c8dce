//! How long a film takes on 1 to 1 000 nodes, simulated: prints the table of docs/farm.md. See benches/README.md.

mod model;
#[path = "../../tests/campaign/rng.rs"]
#[expect(dead_code, reason = "the tests use the rest")]
mod rng;

fn main() {
    println!(
        "The film takes {} of one processor.\n",
        model::time(model::work())
    );
    println!("| tile time | 1 node | 10 nodes | 100 nodes | 1 000 nodes | waste |");
    println!("|---|---:|---:|---:|---:|---:|");
    for row in model::table() {
        println!("{row}");
    }
}
