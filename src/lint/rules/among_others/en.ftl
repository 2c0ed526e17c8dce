N610 = this { $change } of { $id } stands among the records of the { $type } { $other }, which has no { $change }
    .label = it changes { $id }
    .first = the { $type } { $other } is defined here
    .help = if { $id } is meant, write the record below the others of { $id }
