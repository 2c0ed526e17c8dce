W339 = { $type } { $id }: normály leží v rovině trojúhelníku
    .label = s těmito normálami bude trojúhelník tmavý nebo černý
    .help = normála je na trojúhelník kolmá: nejsou dvě čísla prohozená?
W339-interleaved = { $type } { $id }: normály leží v rovině trojúhelníku; možná je každá hned za svým vrcholem
    .label = zde jsou tři normály
    .help = nejdřív jsou tři vrcholy, za nimi tři normály
    .fix = napsat nejdřív vrcholy
