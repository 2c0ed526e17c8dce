N610 = { $change } pro { $id } stojí mezi záznamy jiného objektu ({ $type } { $other }), který takový záznam nemá
    .label = mění { $id }
    .first = zde je { $type } { $other }
    .help = má-li to být { $id }, napište záznam pod ostatní záznamy objektu { $id }
