W334 = { $change } pro { $id } nemá účinek: než se { $id } použije, přepíše to další záznam téhož typu
    .label = toto se přepíše
    .second = přepíše to tento záznam
    .help = jeden z obou záznamů odstraňte, nebo dejte druhému ID objektu, ke kterému patří
    .fix = ve druhém záznamu napsat { $number }
