N609 = the turn is about the origin: it takes the { $type } { $id } from { $from } to { $to }
    .label = this turns it and its place
    .move = it is moved first
    .help = to turn it where it stands, put the turn first
    .fix = swap the two lines: turn it first, then move it
